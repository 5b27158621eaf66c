// Reads samplers of textures and KHR_texture_transform.
#include "host/formats/gltf/texture_reference.h"

#include <fmt/format.h>

#include <cmath>

namespace candela::gltf {
namespace {

constexpr std::uint64_t kRepeat = 10497;
constexpr std::uint64_t kMirroredRepeat = 33648;
constexpr std::uint64_t kClampToEdge = 33071;
constexpr std::uint64_t kNearest = 9728;
constexpr std::uint64_t kLinear = 9729;

scene::TextureWrap wrapOf(const Value& sampler, const char* key) {
  const std::uint64_t mode = sampler.wholeOr(key, kRepeat);
  if (mode == kRepeat) return scene::TextureWrap::repeat;
  if (mode == kMirroredRepeat) return scene::TextureWrap::mirroredRepeat;
  if (mode != kClampToEdge) sampler.require(key).fail(fmt::format("{} is not a wrapping mode", mode));
  return scene::TextureWrap::clampToEdge;
}

}  // namespace

void readSampler(const Value& sampler, scene::TextureReference& reference) {
  reference.wrapS = wrapOf(sampler, "wrapS");
  reference.wrapT = wrapOf(sampler, "wrapT");
  const std::uint64_t filter = sampler.wholeOr("magFilter", kLinear);
  if (filter != kNearest && filter != kLinear)
    sampler.require("magFilter").fail(fmt::format("{} is not a filter", filter));
  reference.filter = filter == kNearest ? scene::TextureFilter::nearest : scene::TextureFilter::linear;
}

void readTransform(const Value& transform, scene::TextureReference& reference) {
  const auto offset = transform.vectorOr("offset", glm::dvec2(0));
  const auto scale = transform.vectorOr("scale", glm::dvec2(1));
  const double rotation = transform.numberOr("rotation", 0);
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  reference.rowS = glm::vec3(glm::dvec3(c * scale.x, s * scale.y, offset.x));
  reference.rowT = glm::vec3(glm::dvec3(-s * scale.x, c * scale.y, offset.y));
}

std::uint64_t texCoordSetOf(const Value& info, const std::optional<Value>& transform) {
  const std::uint64_t set = info.wholeOr("texCoord", 0);
  return transform ? transform->wholeOr("texCoord", set) : set;
}

}  // namespace candela::gltf
