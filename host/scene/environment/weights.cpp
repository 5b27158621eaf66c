// Rounds running sums, so that the sum of the integer weights is exact.
#include "host/scene/environment/weights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/image/film.h"

namespace candela::environment {

double solidAngleOfRow(const scene::Environment& environment, std::uint32_t row) {
  const double pole = environment.offsetOfPoles(), rows = environment.height - 2 * pole;
  const double step = std::numbers::pi / rows;
  return std::cos(std::max(row - pole, 0.0) * step) - std::cos(std::min(row + 1 - pole, rows) * step);
}

void setWeights(scene::Environment& environment) {
  const std::size_t count = environment.texels.size();
  std::vector<double> sums(count);
  double sum = 0, solidAngle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % environment.width == 0) {
      solidAngle = solidAngleOfRow(environment, static_cast<std::uint32_t>(i / environment.width));
    }
    sum += image::luminance(glm::dvec3(environment.texels[i])) * solidAngle;
    sums[i] = sum;
  }
  environment.weights.assign(count, 0);
  if (!(sum > 0)) return;
  const double unit = static_cast<double>(scene::Environment::kMeanWeight * count);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto upTo = static_cast<std::uint64_t>(std::floor(sums[i] / sum * unit + 0.5));
    environment.weights[i] = upTo - below;
    below = upTo;
  }
}

}  // namespace candela::environment
