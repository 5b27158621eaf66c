// Applies what varies over a triangle to its material.
#include "host/reference/textured_material.h"

#include <cmath>

#include "host/reference/opacity.h"
#include "host/reference/texture.h"

namespace candela::reference {
namespace {

// Displaces texture coordinates by a random sign each, if `rounding` does.
dvec2 randomSigns(Rounding& rounding) {
  return {rounding.absolute(0, 1 / kRoundoff), rounding.absolute(0, 1 / kRoundoff)};
}

std::uint32_t lookUp(const scene::Scene& scene, const scene::TextureReference& reference,
                     const MeshAttributes& attributes, const dvec2& jitter, Rounding& rounding) {
  const dvec2 error = randomSigns(rounding) * coordinateErrors(reference, attributes);
  const dvec2 st = textureCoordinates(reference, attributes) + error;
  const std::uint32_t texel = texelAt(scene.images[reference.image], reference, st, jitter);
  rounding.decide(texel);
  return texel;
}

const std::optional<scene::TextureReference>& emissionTextureOf(const scene::Scene& scene,
                                                                const scene::Primitive& primitive) {
  return textureOf(scene.materials[primitive.material], scene::TextureSlot::emission);
}

// The texels of a surface point's material.
struct Texels {
  const scene::Scene& scene;
  const Surface& surface;
  Rounding& rounding;

  std::optional<std::uint32_t> of(scene::TextureSlot slot) const { return texelOf(scene, surface, slot, rounding); }
};

void scaleParameters(const Texels& texels, scene::SurfaceParameters& parameters) {
  if (const auto texel = texels.of(scene::TextureSlot::metallicRoughness)) {
    parameters.roughness *= static_cast<float>(*texel / 256 % 256) / 255;
    parameters.metalness *= static_cast<float>(*texel / 65536 % 256) / 255;
  }
  if (const auto texel = texels.of(scene::TextureSlot::specular)) {
    parameters.specularWeight *= static_cast<float>(alphaOf(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::specularColour)) {
    parameters.specularColour *= glm::vec3(linearColour(*texel));
  }
}

}  // namespace

std::optional<std::uint32_t> texelOf(const scene::Scene& scene, const Surface& surface, scene::TextureSlot slot,
                                     Rounding& rounding) {
  const auto& reference = textureOf(scene.materials[surface.material], slot);
  if (!reference || scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) return std::nullopt;
  return lookUp(scene, *reference, surface.attributes, surface.textureJitter, rounding);
}

void applyTextures(const scene::Scene& scene, const Surface& surface, SurfaceMaterial& material, Rounding& rounding) {
  if (scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) return;
  const bool hasColours = !meshOf(scene, scene.primitives[surface.primitive]).colours.empty();
  if (hasColours) material.scaleBaseColour(dvec3(surface.attributes.colour));
  const Texels texels{scene, surface, rounding};
  if (const auto texel = texels.of(scene::TextureSlot::baseColour)) material.scaleBaseColour(linearColour(*texel));
  if (material.surface) scaleParameters(texels, *material.surface);
  if (const auto texel = texels.of(scene::TextureSlot::emission)) material.emission *= linearColour(*texel);
}

dvec3 emissionFactor(const scene::Scene& scene, const LightSample& light, const dvec2& jitter, Rounding& rounding) {
  if (light.primitive == kNoPrimitive) return dvec3(1);
  const scene::Primitive& primitive = scene.primitives[light.primitive];
  const auto& texture = emissionTextureOf(scene, primitive);
  const bool passes = isTransparent(scene, primitive);
  if (primitive.kind != scene::PrimitiveKind::triangle || (!texture && !passes)) return dvec3(1);
  const MeshAttributes attributes = attributesAt(scene, primitive, light.barycentrics, dvec3(0));
  dvec3 factor(1);
  if (texture) factor = linearColour(lookUp(scene, *texture, attributes, jitter, rounding));
  if (passes) {
    const double opacity = opacityAt(scene, primitive, attributes, jitter, randomSigns(rounding));
    rounding.decide(static_cast<std::uint64_t>(std::lround(opacity * 65536)));
    factor *= opacity;
  }
  return factor;
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
