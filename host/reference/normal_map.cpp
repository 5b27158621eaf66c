// Turns shading normals by the texels of normal maps.
#include "host/reference/normal_map.h"

#include <algorithm>

#include "host/reference/textured_material.h"

namespace candela::reference {
namespace {

// The components of a direction that a texel encodes in red, green and blue.
dvec3 directionOf(Texel texel) { return 2.0 * dvec3(redOf(texel), greenOf(texel), blueOf(texel)) - 1.0; }

}  // namespace

void applyNormalMap(const scene::Scene& scene, scene::TextureSlot slot, Surface& surface, Rounding& rounding) {
  const MeshAttributes& attributes = surface.attributes;
  const std::optional<Texel> texel = texelOf(scene, surface, slot, rounding);
  if (!texel || attributes.tangent == dvec3(0)) return;
  const scene::Material& material = scene.materials[surface.material];
  const double scale = slot == scene::TextureSlot::normal ? material.normalScale : material.coatNormalScale;
  const dvec3 c = directionOf(*texel);
  dvec3 mapped = c.x * scale * attributes.tangent + c.y * scale * attributes.bitangent + c.z * surface.smoothNormal;
  if (mapped == dvec3(0)) return;
  mapped = normalize(mapped);
  const double cosine = dot(mapped, surface.outwardNormal);
  if (cosine < 0) mapped -= 2 * cosine * surface.outwardNormal;
  surface.shadingNormal = surface.fromOutside ? mapped : -mapped;
  surface.isMapped = true;
}

double NormalMapFacets::directProbability(const dvec3& wo) const {
  const double direct = std::max(0.0, wo.z);
  const double reflected = std::max(0.0, -dot(wo, tilt()));
  return reflected > 0 ? direct / (direct + reflected) : 1;
}

dvec3 NormalMapFacets::seenByReflection(const dvec3& wo) const {
  const dvec3 neighbour = normalize(tilt());
  return wo - 2 * dot(wo, neighbour) * neighbour;
}

}  // namespace candela::reference
