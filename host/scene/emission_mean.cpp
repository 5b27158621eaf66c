// Averages the texture and the vertex colours of an emitter.
#include "host/scene/emission_mean.h"

#include <algorithm>
#include <cmath>

#include "host/image/colour_transfer.h"

namespace candela::scene {
namespace {

constexpr std::uint32_t kDivisions = 8;  // of each edge

std::uint32_t texelAlong(double s, std::uint32_t count, TextureWrap wrap) {
  constexpr double kLimit = 8388608;
  if (!(std::abs(s) < kLimit)) s = 0;
  if (wrap == TextureWrap::repeat) s -= std::floor(s);
  if (wrap == TextureWrap::mirroredRepeat) s = 1 - std::abs(s - 2 * std::floor(s / 2) - 1);
  const double texel = std::floor(s * count);
  return static_cast<std::uint32_t>(std::clamp(texel, 0.0, count - 1.0));
}

glm::dvec3 colourAt(const TextureImage& image, const TextureReference& reference, const glm::dvec2& uv) {
  const glm::dvec3 point(uv, 1);
  const std::uint32_t x = texelAlong(glm::dot(glm::dvec3(reference.rowS), point), image.width, reference.wrapS);
  const std::uint32_t y = texelAlong(glm::dot(glm::dvec3(reference.rowT), point), image.height, reference.wrapT);
  const std::size_t index = std::size_t{y} * image.width + x;
  const int bits = image.isDeep() ? 16 : 8;
  const std::uint64_t texel = image.isDeep() ? image.deepTexels[index] : image.texels[index];
  const std::uint64_t largest = (1u << bits) - 1;
  const auto linear = [&](int channel) {
    const auto stored = static_cast<double>(texel >> bits * channel & largest);
    return double{static_cast<float>(image::srgbDecode(stored / static_cast<double>(largest)))};
  };
  return {linear(0), linear(1), linear(2)};
}

}  // namespace

glm::dvec3 meanEmissionTexel(const Scene& scene, const Primitive& triangle) {
  const auto& reference = textureOf(scene.materials[triangle.material], TextureSlot::emission);
  const std::vector<glm::vec4>* const colours = coloursOfEmission(scene, triangle);
  if (!reference && !colours) return glm::dvec3(1);
  const Mesh& mesh = meshOf(scene, triangle);
  std::array<glm::vec2, 3> uv{};
  if (reference && !mesh.texCoords[reference->texCoordSet].empty()) {
    uv = attributeOf(mesh, mesh.texCoords[reference->texCoordSet], triangle.index);
  }
  std::array<glm::vec4, 3> corners{glm::vec4(1), glm::vec4(1), glm::vec4(1)};
  if (colours) corners = attributeOf(mesh, *colours, triangle.index);
  glm::dvec3 sum(0);
  const auto add = [&](double i, double j) {
    const double b1 = i / kDivisions;
    const double b2 = j / kDivisions;
    const glm::dvec2 at = (1 - b1 - b2) * glm::dvec2(uv[0]) + b1 * glm::dvec2(uv[1]) + b2 * glm::dvec2(uv[2]);
    const glm::dvec3 colour = (1 - b1 - b2) * glm::dvec3(corners[0]) + b1 * glm::dvec3(corners[1]) +
                              b2 * glm::dvec3(corners[2]);
    sum += reference ? colour * colourAt(scene.images[reference->image], *reference, at) : colour;
  };
  for (std::uint32_t i = 0; i < kDivisions; ++i) {
    for (std::uint32_t j = 0; i + j < kDivisions; ++j) {
      add(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < kDivisions) add(i + 2.0 / 3, j + 2.0 / 3);
    }
  }
  return sum / double{kDivisions * kDivisions};
}

}  // namespace candela::scene
