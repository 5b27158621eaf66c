// The samplers of animations: key frames and the interpolation between them.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "host/formats/gltf/accessor.h"

namespace candela::gltf {

enum class Interpolation : std::uint8_t { step, linear, cubic };

/// Values at key frames, `width` numbers each; of CUBICSPLINE, three times as many: in-tangent, value, out-tangent.
struct Sampler {
  std::vector<float> times;
  std::vector<float> values;
  Interpolation interpolation;
  std::size_t width;

  const float* frame(std::size_t i) const {
    return values.data() + i * width * (interpolation == Interpolation::cubic ? 3 : 1);
  }
  const float* value(std::size_t i) const { return frame(i) + (interpolation == Interpolation::cubic ? width : 0); }
};

/// Converts from the order of components that files have.
inline glm::dquat asQuaternion(const std::vector<double>& xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

/// Reads a sampler. `components`: 2 to 4 numbers for each frame, or 1 of which each frame has any number. Throws
/// JsonError.
Sampler readSampler(const Value& sampler, std::size_t components, Accessors& accessors);

/// Returns the numbers at a time. Before the first and after the last frame, the values of that frame apply. Rotations
/// are interpolated on the unit sphere.
std::vector<double> evaluate(const Sampler& sampler, double seconds, bool isRotation);

}  // namespace candela::gltf
