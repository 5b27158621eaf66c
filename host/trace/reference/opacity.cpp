// Decides whether rays hit transparent triangles.
#include "host/trace/reference/opacity.h"

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/sampler.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kOpacitySeed = 0x6f706163u;

}  // namespace

std::uint32_t opacityKey(std::uint32_t pixel, std::uint32_t sample, std::uint32_t seed, std::uint32_t vertex,
                         bool isShadowRay) {
  const std::uint32_t ray = 2 * vertex + static_cast<std::uint32_t>(isShadowRay);
  return pcg4d({pixel, sample, ray, seed ^ kOpacitySeed})[0];
}

bool isTransparent(const scene::Scene& scene, const scene::Primitive& primitive) {
  return primitive.kind == scene::PrimitiveKind::triangle && scene.materials[primitive.material].opacity.has_value();
}

double opacityAt(const scene::Scene& scene, const scene::Primitive& triangle, const MeshAttributes& attributes,
                 const dvec2& st, const dvec2& jitter) {
  const scene::Opacity& opacity = *scene.materials[triangle.material].opacity;
  double alpha = opacity.factor;
  if (!meshOf(scene, triangle).colours.empty()) alpha *= attributes.colour.w;
  if (opacity.texture) {
    const scene::TextureImage& image = scene.images[opacity.texture->image];
    alpha *= opacity.cutoff ? filteredTexel(image, *opacity.texture, st).w
                            : alphaOf(texelAt(image, *opacity.texture, st, jitter));
  }
  if (!opacity.cutoff) return alpha;
  return alpha >= double{*opacity.cutoff} ? 1 : 0;
}

MeshAttributes attributesAtHit(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray) {
  const scene::Primitive& triangle = scene.primitives[primitive];
  return attributesAt(scene, triangle, TriangleShape(triangleOf(scene, triangle)).barycentrics(ray), dvec3(0));
}

bool isThere(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray, const MeshAttributes& attributes,
             const dvec2& st) {
  const Words words = pcg4d({ray.opacityKey, primitive, 0, 0});
  const dvec2 jitter(toUnit(words[1]), toUnit(words[2]));
  return toUnit(words[0]) < opacityAt(scene, scene.primitives[primitive], attributes, st, jitter);
}

bool isThere(const scene::Scene& scene, std::uint32_t primitive, const Ray& ray) {
  const MeshAttributes attributes = attributesAtHit(scene, primitive, ray);
  const auto& texture = scene.materials[scene.primitives[primitive].material].opacity->texture;
  return isThere(scene, primitive, ray, attributes, texture ? textureCoordinates(*texture, attributes) : dvec2(0));
}

}  // namespace candela::reference
