// Filters in two passes. The inner loops follow rows, so that compilers vectorise them.
#include "host/image/separable_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela::image {
namespace {

void addScaled(double* target, const double* source, double weight, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) target[i] += weight * source[i];
}

Plane filteredRows(const Plane& in, const Kernel& kernel) {
  Plane out{in.width, in.height, std::vector<double>(in.values.size())};
  const std::size_t radius = kernel.size() / 2;
  std::vector<double> padded(in.width + 2 * radius);
  for (std::uint32_t y = 0; y < in.height; ++y) {
    const double* row = in.values.data() + std::size_t{y} * in.width;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, in.width, padded.data() + radius);
    std::fill_n(padded.data() + radius + in.width, radius, row[in.width - 1]);
    double* target = out.values.data() + std::size_t{y} * in.width;
    for (std::size_t i = 0; i < kernel.size(); ++i) addScaled(target, padded.data() + i, kernel[i], in.width);
  }
  return out;
}

Plane filteredColumns(const Plane& in, const Kernel& kernel) {
  Plane out{in.width, in.height, std::vector<double>(in.values.size())};
  const auto radius = static_cast<std::int64_t>(kernel.size() / 2);
  const std::int64_t lastRow = std::int64_t{in.height} - 1;
  for (std::int64_t y = 0; y <= lastRow; ++y) {
    double* target = out.values.data() + static_cast<std::size_t>(y) * in.width;
    for (std::size_t j = 0; j < kernel.size(); ++j) {
      const std::int64_t source = std::clamp<std::int64_t>(y + static_cast<std::int64_t>(j) - radius, 0, lastRow);
      addScaled(target, in.values.data() + static_cast<std::size_t>(source) * in.width, kernel[j], in.width);
    }
  }
  return out;
}

}  // namespace

Plane filtered(const Plane& in, const Kernel& horizontal, const Kernel& vertical) {
  if (in.values.empty()) return {in.width, in.height, {}};
  return filteredColumns(filteredRows(in, horizontal), vertical);
}

Kernel gaussian(int radius, double deviation) {
  Kernel kernel;
  for (int x = -radius; x <= radius; ++x) kernel.push_back(std::exp(-x * x / (2 * deviation * deviation)));
  return kernel;
}

double sum(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

}  // namespace candela::image
