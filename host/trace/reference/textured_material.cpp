// Applies the textures and vertex colours of a triangle to its material.
#include "host/trace/reference/textured_material.h"

#include <cmath>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/opacity.h"
#include "host/trace/reference/texture.h"

namespace candela::reference {
namespace {

// Returns the cosine of the sampled direction to the normal of a sphere or triangle that is a light.
double cosineAtLight(const scene::Scene& scene, const LightSample& light, const Surface& lit) {
  const scene::Primitive& primitive = scene.primitives[light.primitive];
  const dvec3 normal = primitive.kind == scene::PrimitiveKind::triangle
                           ? normalize(TriangleShape(triangleOf(scene, primitive)).areaNormal())
                           : SphereShape(scene.spheres[primitive.index])
                                 .normal(lit.position + light.distance * light.wi);
  return std::abs(dot(normal, light.wi));
}

// The texels of a surface point's material.
struct Texels {
  const TextureReader& textures;
  const Surface& surface;

  std::optional<Texel> of(scene::TextureSlot slot) const { return textures.at(surface, slot); }
};

void scale(float& parameter, double factor) { parameter *= static_cast<float>(factor); }

void scaleParameters(const Texels& texels, scene::SurfaceParameters& parameters) {
  if (const auto texel = texels.of(scene::TextureSlot::metallicRoughness)) {
    scale(parameters.roughness, greenOf(*texel));
    scale(parameters.metalness, blueOf(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::glossiness)) {
    const double glossiness = (1 - double{parameters.roughness}) * alphaOf(*texel);
    parameters.roughness = static_cast<float>(1 - glossiness);
  }
  if (const auto texel = texels.of(scene::TextureSlot::specular)) {
    scale(parameters.specularWeight, alphaOf(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::specularColour)) {
    parameters.specularColour *= glm::vec3(linearColour(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::transmission))
    scale(parameters.transmissionWeight, redOf(*texel));
  if (const auto texel = texels.of(scene::TextureSlot::coat)) scale(parameters.coatWeight, redOf(*texel));
  if (const auto texel = texels.of(scene::TextureSlot::coatRoughness)) scale(parameters.coatRoughness, greenOf(*texel));
  if (const auto texel = texels.of(scene::TextureSlot::sheenColour)) {
    parameters.sheenColour *= glm::vec3(linearColour(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::sheenRoughness)) {
    scale(parameters.sheenRoughness, alphaOf(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::film)) {
    scale(parameters.filmWeight, redOf(*texel));
  }
  if (const auto texel = texels.of(scene::TextureSlot::filmThickness)) {
    parameters.filmThickness = std::lerp(parameters.filmThicknessMinimum, parameters.filmThickness,
                                         static_cast<float>(greenOf(*texel)));
  }
}

}  // namespace

Texel TextureReader::read(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes,
                          const dvec2& jitter) const {
  const dvec2 st = arithmetic.texCoords(texture, attributes);
  const Texel texel = texelAt(scene.images[texture->image], *texture, st, jitter);
  arithmetic.decide(texel);
  return texel;
}

dvec2 TextureReader::gradientOfRed(const std::optional<scene::TextureReference>& texture,
                                   const MeshAttributes& attributes) const {
  const dvec2 st = arithmetic.texCoords(texture, attributes);
  const scene::TextureImage& image = scene.images[texture->image];
  for (const dvec2& corner : {dvec2(0, 0), dvec2(1, 1)}) arithmetic.decide(texelAt(image, *texture, st, corner));
  return reference::gradientOfRed(image, *texture, st);
}

glm::dvec4 TextureReader::filtered(const std::optional<scene::TextureReference>& texture,
                                   const MeshAttributes& attributes) const {
  const dvec2 st = arithmetic.texCoords(texture, attributes);
  const scene::TextureImage& image = scene.images[texture->image];
  if (texture->filter == scene::TextureFilter::nearest) arithmetic.decide(texelAt(image, *texture, st, dvec2(0)));
  return filteredTexel(image, *texture, st);
}

std::optional<Texel> TextureReader::at(const Surface& surface, scene::TextureSlot slot) const {
  const auto& texture = textureOf(scene.materials[surface.material], slot);
  if (!texture || scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) return std::nullopt;
  return read(texture, surface.attributes, surface.textureJitter);
}

void applyTextures(const TextureReader& textures, const Surface& surface, SurfaceMaterial& material) {
  const scene::Scene& scene = textures.scene;
  if (scene.primitives[surface.primitive].kind != scene::PrimitiveKind::triangle) return;
  const bool hasColours = !meshOf(scene, scene.primitives[surface.primitive]).colours.empty();
  if (hasColours) material.scaleBaseColour(dvec3(surface.attributes.colour));
  if (coloursOfEmission(scene, scene.primitives[surface.primitive])) {
    material.emission *= dvec3(surface.attributes.colour);
  }
  const Texels texels{textures, surface};
  if (const auto texel = texels.of(scene::TextureSlot::baseColour)) material.scaleBaseColour(linearColour(*texel));
  if (material.surface) scaleParameters(texels, *material.surface);
  if (const auto texel = texels.of(scene::TextureSlot::emission)) material.emission *= linearColour(*texel);
}

void dimEmission(const Surface& surface, const dvec3& rayDirection, SurfaceMaterial& material) {
  if (!material.emits || !material.surface) return;
  const double cosine = std::abs(dot(rayDirection, surface.outwardNormal));
  material.emission *= 1 - coatReflectance(material.surface->coatWeight, cosine);
}

dvec3 emissionFactor(const TextureReader& textures, const LightSample& light, const Surface& lit) {
  const scene::Scene& scene = textures.scene;
  if (light.primitive == kNoPrimitive) return dvec3(1);
  const scene::Primitive& primitive = scene.primitives[light.primitive];
  const dvec2& jitter = lit.lightTextureJitter;
  const scene::Material& material = scene.materials[primitive.material];
  double coatWeight = material.surface ? material.surface->coatWeight : 0;
  dvec3 factor(1);
  if (primitive.kind == scene::PrimitiveKind::triangle) {
    const MeshAttributes attributes = attributesAt(scene, primitive, light.barycentrics, dvec3(0));
    const auto texel = [&](scene::TextureSlot slot) -> std::optional<Texel> {
      const auto& texture = textureOf(material, slot);
      return texture ? std::optional(textures.read(texture, attributes, jitter)) : std::nullopt;
    };
    if (const auto emission = texel(scene::TextureSlot::emission)) factor = linearColour(*emission);
    if (coloursOfEmission(scene, primitive)) factor *= dvec3(attributes.colour);
    if (const auto coat = coatWeight > 0 ? texel(scene::TextureSlot::coat) : std::nullopt)
      coatWeight *= static_cast<float>(redOf(*coat));
    if (isTransparent(scene, primitive)) {
      const dvec2 st = textures.arithmetic.texCoords(material.opacity->texture, attributes);
      const double opacity = opacityAt(scene, primitive, attributes, st, jitter);
      textures.arithmetic.decide(static_cast<std::uint64_t>(std::lround(opacity * 65536)));
      factor *= opacity;
    }
  }
  return coatWeight > 0 ? factor * (1 - coatReflectance(coatWeight, cosineAtLight(scene, light, lit))) : factor;
}

dvec3 meanEmissionTexel(const scene::Scene& scene, const scene::Primitive& triangle) {
  std::optional<scene::TextureReference> texture = textureOf(scene.materials[triangle.material],
                                                             scene::TextureSlot::emission);
  const bool hasColours = coloursOfEmission(scene, triangle) != nullptr;
  if (!texture && !hasColours) return dvec3(1);
  if (texture) texture->filter = scene::TextureFilter::nearest;
  Arithmetic exact;
  const TextureReader textures{scene, exact};
  constexpr int kParts = 8;
  dvec3 sum(0);
  for (int k = 0; k < 3 * kParts * 3 * kParts; ++k) {
    const int i = k % (3 * kParts);  // centres of the parts have both coordinates 1 or both 2 modulo 3
    const int j = k / (3 * kParts);
    if (i % 3 == 0 || i % 3 != j % 3 || i + j >= 3 * kParts) continue;
    const dvec2 b(i / (3.0 * kParts), j / (3.0 * kParts));
    const MeshAttributes attributes = attributesAt(scene, triangle, b, dvec3(0));
    const dvec3 colour = hasColours ? dvec3(attributes.colour) : dvec3(1);
    sum += texture ? colour * linearColour(textures.read(texture, attributes, dvec2(0))) : colour;
  }
  return sum / double{kParts * kParts};
}

}  // namespace candela::reference
