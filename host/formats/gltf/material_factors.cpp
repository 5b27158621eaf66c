// Factors of materials.
#include "host/formats/gltf/material_factors.h"

#include <fmt/format.h>

#include <algorithm>

namespace candela::gltf {

double clampedFraction(const Value& source, double value) {
  constexpr double kRounding = 1e-5;
  if (value < -kRounding || value > 1 + kRounding) source.fail(fmt::format("{} is outside 0 to 1", value));
  return std::clamp(value, 0.0, 1.0);
}

double fraction(const Value& object, const char* key, double absent) {
  const std::optional<Value> value = object.find(key);
  return value ? clampedFraction(*value, value->number()) : absent;
}

double atLeastZero(const Value& object, const char* key, double absent) {
  const double value = object.numberOr(key, absent);
  if (value < 0) object.require(key).fail(fmt::format("{} is negative", value));
  return value;
}

glm::vec3 atLeastZero(const Value& object, const char* key, const glm::vec3& absent) {
  const glm::vec3 value = object.vectorOr(key, absent);
  if (glm::any(glm::lessThan(value, glm::vec3(0)))) object.require(key).fail("a component is negative");
  return value;
}

std::optional<scene::TextureReference> textureIn(const Value& object, const char* key,
                                                 const TextureReader& readTexture) {
  const std::optional<Value> info = object.find(key);
  return info ? readTexture(*info) : std::nullopt;
}

double scaleIn(const Value& object, const char* key) {
  const std::optional<Value> info = object.find(key);
  return info ? info->numberOr("scale", 1) : 1;
}

}  // namespace candela::gltf
