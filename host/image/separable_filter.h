// Convolution of planes of numbers with products of two one-dimensional kernels.
#pragma once
#include <cstdint>
#include <vector>

namespace candela::image {

/// One number a pixel, row by row from the top.
struct Plane {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<double> values;
};

/// Weights for the offsets -radius to radius; their count is odd.
using Kernel = std::vector<double>;

/// out(x, y) = sum over i, j of horizontal[i] vertical[j] in(x + i, y + j), where i and j are offsets from the centre.
/// Beyond its edges the plane goes on with its outermost values.
Plane filtered(const Plane& in, const Kernel& horizontal, const Kernel& vertical);

}  // namespace candela::image
