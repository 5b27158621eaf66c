// Numbers that textures give, before they are texels of a material.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/scene/texture.h"

namespace candela::mitsuba {

/// One number for each texel of an image, row by row from the top.
struct Numbers {
  /// The use of the image that will have the numbers, whose index is not set; empty: no image, but one number.
  std::optional<scene::TextureReference> use{};
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::vector<double> values{0};  ///< one, which all texels have, or one for each texel
  std::string name{};             ///< that determines `values`

  double at(std::size_t texel) const { return values.size() == 1 ? values[0] : values[texel]; }
};

/// Gives all of them one use, width and height, namely the largest ones: images that are smaller are resampled at the
/// centres of texels, with the filter of their use. Where a texture has another transform, wrap mode or filter than the
/// first one, its largest number takes its place, and false is returned.
bool putOnOneGrid(std::span<Numbers> numbers);

/// Returns the texel of 16 bits per channel whose red, green, blue and alpha are these fractions of the largest
/// integer, limited to [0, 1].
std::uint64_t deepTexelOf(const glm::dvec3& colour, double alpha = 1);

}  // namespace candela::mitsuba
