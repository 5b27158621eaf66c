// Reads the factors and textures of materials, and checks the ranges of factors.
#pragma once
#include <optional>

#include "host/formats/gltf/gltf_material.h"

namespace candela::gltf {
/// Returns a factor, clamped to 0 to 1 if it is outside by no more than the rounding of a program that wrote it. Throws
/// JsonError at `source` otherwise.
double clampedFraction(const Value& source, double value);
/// Returns a member from 0 to 1; `absent` if the object lacks it. Throws as clampedFraction() does.
double fraction(const Value& object, const char* key, double absent);

/// Returns a member whose components are from 0 to 1.
template <class Vector>
Vector fractions(const Value& object, const char* key, const Vector& absent) {
  Vector value = object.vectorOr(key, absent);
  const std::optional<Value> source = object.find(key);
  for (glm::length_t c = 0; source && c < Vector::length(); ++c) {
    value[c] = static_cast<float>(clampedFraction(*source, double{value[c]}));
  }
  return value;
}

/// Returns a member that is not negative; `absent` if the object lacks it. Throws JsonError.
double atLeastZero(const Value& object, const char* key, double absent);
glm::vec3 atLeastZero(const Value& object, const char* key, const glm::vec3& absent);

/// Reads the `textureInfo` of a member; nothing if the object lacks it.
std::optional<scene::TextureReference> textureIn(const Value& object, const char* key,
                                                 const TextureReader& readTexture);
/// Returns the scale of a normal map.
double scaleIn(const Value& object, const char* key);

}  // namespace candela::gltf
