// Convolution of planes of numbers with separable kernels.
#pragma once
#include <cstdint>
#include <vector>

namespace candela::image {

/// One number per pixel, row by row from the top.
struct Plane {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<double> values;
};

/// Weights for the offsets -radius to radius. Their count is odd.
using Kernel = std::vector<double>;

/// Returns exp(-x^2 / (2 deviation^2)) for -radius <= x <= radius.
Kernel gaussian(int radius, double deviation);
/// Returns the sum of the weights.
double sum(const Kernel& kernel);
/// Multiplies the weights by a factor.
Kernel scaled(Kernel kernel, double factor);

/// out(x, y) = sum over i, j of horizontal[i] vertical[j] in(x + i, y + j), where i and j are offsets from the centre.
/// Values beyond the edges are those of the nearest pixel.
Plane filtered(const Plane& in, const Kernel& horizontal, const Kernel& vertical);

}  // namespace candela::image
