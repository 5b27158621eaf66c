// Looks up the textures of a material.
#include "host/reference/textured_material.h"

#include "host/reference/texture.h"

namespace candela::reference {
namespace {

// Returns the coordinate row.uv + offset with the error of single precision.
double coordinate(const glm::vec3& row, const dvec2& uv, const dvec2& scale, Rounding& rounding) {
  const dvec3 terms(glm::dvec3(row) * dvec3(uv, 1));
  const dvec3 magnitudes(glm::abs(glm::dvec3(row)) * dvec3(scale, 1));
  const double size = 1 + magnitudes.x + magnitudes.y + magnitudes.z;
  return rounding.absolute(terms.x + terms.y + terms.z, kRoundingBounds.texCoord * size);
}

std::uint32_t lookUp(const scene::Scene& scene, const scene::TextureReference& reference,
                     const MeshAttributes& attributes, const dvec2& jitter, Rounding& rounding) {
  const dvec2& uv = attributes.texCoords[reference.texCoordSet];
  const dvec2& scale = attributes.texCoordScale[reference.texCoordSet];
  const dvec2 st(coordinate(reference.rowS, uv, scale, rounding), coordinate(reference.rowT, uv, scale, rounding));
  const std::uint32_t texel = texelAt(scene.images[reference.image], reference, st, jitter);
  rounding.decide(texel);
  return texel;
}

const std::optional<scene::TextureReference>& emissionTextureOf(const scene::Scene& scene,
                                                                const scene::Primitive& primitive) {
  return textureOf(scene.materials[primitive.material], scene::TextureSlot::emission);
}

}  // namespace

void applyTextures(const scene::Scene& scene, const Surface& surface, SurfaceMaterial& material, Rounding& rounding) {
  if (scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) return;
  const scene::Material& source = scene.materials[surface.material];
  const auto texel = [&](const scene::TextureReference& reference) {
    return linearColour(lookUp(scene, reference, surface.attributes, surface.textureJitter, rounding));
  };
  if (const auto& baseColour = textureOf(source, scene::TextureSlot::baseColour)) {
    material.bsdf.scaleBaseColour(texel(*baseColour));
  }
  if (const auto& emission = textureOf(source, scene::TextureSlot::emission)) material.emission *= texel(*emission);
}

dvec3 emissionTexel(const scene::Scene& scene, const LightSample& light, const dvec2& jitter, Rounding& rounding) {
  if (light.primitive == kNoPrimitive) return dvec3(1);
  const scene::Primitive& primitive = scene.primitives[light.primitive];
  const auto& texture = emissionTextureOf(scene, primitive);
  if (!texture || primitive.kind != scene::PrimitiveKind::triangle) return dvec3(1);
  const MeshAttributes attributes = attributesAt(scene, primitive, light.barycentrics, dvec3(0));
  return linearColour(lookUp(scene, *texture, attributes, jitter, rounding));
}

dvec3 meanEmissionTexel(const scene::Scene& scene, const scene::Primitive& triangle) {
  const auto& texture = emissionTextureOf(scene, triangle);
  if (!texture) return dvec3(1);
  scene::TextureReference nearest = *texture;
  nearest.filter = scene::TextureFilter::nearest;
  Rounding exact;
  constexpr int kParts = 8;
  dvec3 sum(0);
  for (int k = 0; k < 3 * kParts * 3 * kParts; ++k) {
    const int i = k % (3 * kParts);  // centres of the parts have both coordinates 1 or both 2 modulo 3
    const int j = k / (3 * kParts);
    if (i % 3 == 0 || i % 3 != j % 3 || i + j >= 3 * kParts) continue;
    const dvec2 b(i / (3.0 * kParts), j / (3.0 * kParts));
    const MeshAttributes attributes = attributesAt(scene, triangle, b, dvec3(0));
    sum += linearColour(lookUp(scene, nearest, attributes, dvec2(0), exact));
  }
  return sum / double{kParts * kParts};
}

}  // namespace candela::reference
