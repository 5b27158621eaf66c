// Turns shading normals by the texels of normal maps.
#include "host/trace/reference/normal_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host/base/hypotenuse.h"
#include "host/trace/reference/bump_map.h"

namespace candela::reference {
namespace {

// Returns red, green and blue of a normal map at a surface point; nothing without one.
std::optional<dvec3> colourOfMap(const TextureReader& textures, scene::TextureSlot slot, const Surface& surface) {
  const scene::Material& material = textures.scene.materials[surface.material];
  const auto& texture = textureOf(material, slot);
  if (!texture || textures.scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) {
    return std::nullopt;
  }
  return dvec3(material.hasFacets ? channelsOf(textures.read(texture, surface.attributes, surface.textureJitter))
                                  : textures.filtered(texture, surface.attributes));
}

// Returns the direction that a map encodes, in the space of the scene, of any length.
std::optional<dvec3> mappedDirection(const TextureReader& textures, scene::TextureSlot slot, const Surface& surface) {
  const std::optional<dvec3> colour = colourOfMap(textures, slot, surface);
  if (!colour) return std::nullopt;
  const scene::Material& material = textures.scene.materials[surface.material];
  const double scale = slot == scene::TextureSlot::normal ? material.normalScale : material.coatNormalScale;
  const dvec3 c = 2.0 * *colour - 1.0;
  const auto& [tangent, bitangent] = std::pair(surface.attributes.tangent, surface.attributes.bitangent);
  return c.x * scale * tangent + c.y * scale * bitangent + c.z * surface.smoothNormal;
}

}  // namespace

void applyNormalMap(const TextureReader& textures, scene::TextureSlot slot, const dvec3& rayDirection,
                    Surface& surface) {
  const scene::Material& material = textures.scene.materials[surface.material];
  const bool hasHeights = material.hasHeights && slot == scene::TextureSlot::normal;
  const std::optional<dvec3> normal = hasHeights ? bumpedNormal(textures, surface)
                                                 : mappedDirection(textures, slot, surface);
  if (!normal || *normal == dvec3(0) || surface.attributes.tangent == dvec3(0)) return;
  dvec3 mapped = normalize(*normal);
  surface.isMapped = material.hasFacets;
  if (!material.hasFacets) {
    surface.unmappedNormal = surface.smoothNormal;
    const bool isAway = dot(mapped, rayDirection) * dot(surface.smoothNormal, rayDirection) <= 0;
    textures.arithmetic.decide(isAway);
    if (isAway) mapped = 2 * dot(mapped, surface.smoothNormal) * surface.smoothNormal - mapped;
  } else if (const double cosine = dot(mapped, surface.outwardNormal); cosine < 0) {
    mapped -= 2 * cosine * surface.outwardNormal;
  }
  surface.shadingNormal = surface.fromOutside ? mapped : -mapped;
}

double bumpShadowing(const dvec3& mapped, const dvec3& unmapped, const dvec3& wi) {
  const auto squaredTangent = [&](const dvec3& w) {
    const double cosine = dot(unmapped, w);
    const dvec3 across = w - cosine * unmapped;
    return dot(across, across) / (cosine * cosine);
  };
  const double alphaSquared = std::min(squaredTangent(mapped) / 8, 1.0);
  const double fraction = 2 / (1 + std::sqrt(1 + alphaSquared * squaredTangent(wi)));
  return std::isnan(fraction) ? 0 : fraction;
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

// The angle from the mapped normal changes to one from the geometric normal, about their common tangent. Their sines,
// downwards, are linear functions of each other.
dvec3 NormalMapFacets::scatteredAgain(const dvec3& w) const {
  const dvec3 tangent = cross(dvec3(0, 0, 1), geometric_);
  if (tangent == dvec3(0)) return mirrored(w);
  const dvec3 axis = normalize(tangent);
  const dvec3 downFacet = cross(axis, dvec3(0, 0, -1)), downSurface = cross(axis, -geometric_);
  const double along = dot(w, axis), down = dot(w, downFacet);
  const double radius = hypotenuse(down, w.z);
  const double depth = std::clamp((1 - down / radius) / (2 * sunkFraction()), 0.0, 1.0);
  const double sine = 2 * depth - 1;
  return along * axis + radius * (sine * downSurface + std::sqrt(1 - sine * sine) * geometric_);
}

}  // namespace candela::reference
