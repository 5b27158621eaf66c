// Tilts normals by the gradient of heights.
#include "host/trace/reference/bump_map.h"

#include "host/trace/reference/geometry.h"

namespace candela::reference {
namespace {

// The derivatives of a triangle's points by the coordinates s and t of a texture.
struct Derivatives {
  dvec3 byS, byT;
};

std::optional<Derivatives> derivativesOf(const scene::Scene& scene, const scene::Primitive& triangle,
                                         const scene::TextureReference& texture) {
  const scene::Triangle corners = triangleOf(scene, triangle);
  const auto coordinatesAt = [&](const dvec2& b) {
    return textureCoordinates(texture, attributesAt(scene, triangle, b, dvec3(0)));
  };
  const dvec2 origin = coordinatesAt({0, 0});
  const glm::dmat2 sides(coordinatesAt({1, 0}) - origin, coordinatesAt({0, 1}) - origin);
  if (determinant(sides) == 0) return std::nullopt;
  const glm::dmat2 inverse = glm::inverse(sides);
  const dvec3 edge1 = dvec3(corners.p[1]) - dvec3(corners.p[0]), edge2 = dvec3(corners.p[2]) - dvec3(corners.p[0]);
  return Derivatives{inverse[0][0] * edge1 + inverse[0][1] * edge2, inverse[1][0] * edge1 + inverse[1][1] * edge2};
}

}  // namespace

// The displaced surface has the derivatives a + n h_s and b + n h_t, to which n - g is perpendicular if g . a = h_s and
// g . b = h_t.
std::optional<dvec3> bumpedNormal(const TextureReader& textures, const Surface& surface) {
  const scene::Scene& scene = textures.scene;
  const scene::Primitive& triangle = scene.primitives[surface.primitive];
  const scene::Material& material = scene.materials[surface.material];
  const auto& texture = textureOf(material, scene::TextureSlot::normal);
  if (!material.hasHeights || !texture || triangle.kind != scene::PrimitiveKind::triangle) return std::nullopt;
  const std::optional<Derivatives> derivatives = derivativesOf(scene, triangle, *texture);
  if (!derivatives) return std::nullopt;
  const dvec3& n = surface.smoothNormal;
  const dvec3 a = derivatives->byS - dot(derivatives->byS, n) * n, b = derivatives->byT - dot(derivatives->byT, n) * n;
  const glm::dmat2 products(dot(a, a), dot(a, b), dot(a, b), dot(b, b));
  if (determinant(products) <= 0) return std::nullopt;
  const dvec2 slopes = double{material.normalScale} * textures.gradientOfRed(*texture, surface.attributes);
  const dvec2 parts = glm::inverse(products) * slopes;
  return n - parts.x * a - parts.y * b;
}

}  // namespace candela::reference
