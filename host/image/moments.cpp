// Converts moments and pictures of variances.
#include "host/image/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/image/film.h"

namespace candela::image {
namespace {

const Channel* channelNamed(const Image& image, const std::string& name) {
  const auto found = std::ranges::find(image.channels, name, &Channel::name);
  return found == image.channels.end() ? nullptr : &*found;
}

}  // namespace

bool takeMoments(Image& image) {
  const std::string prefix = "m2_", suffix = ".Y";
  const Channel* second = nullptr;
  for (const Channel& channel : image.channels) {
    if (!channel.name.starts_with(prefix) || !channel.name.ends_with(suffix)) continue;
    if (second != nullptr) {
      throw FileError(fmt::format("it has the moments of several integrators, {} and {}", second->name, channel.name));
    }
    second = &channel;
  }
  const Channel* const first = second == nullptr ? nullptr : channelNamed(image, second->name.substr(prefix.size()));
  if (first == nullptr) return false;
  image.luminanceVariance.resize(first->values.size());
  for (std::size_t i = 0; i < first->values.size(); ++i) {
    const double mean = first->values[i];
    const double variance = second->values[i] - mean * mean;
    image.luminanceVariance[i] = variance < 0 ? 0 : static_cast<float>(variance);  // NaN stays
  }
  return true;
}

void takeVariances(Image& image, const Image& variances) {
  constexpr double kRounding = 0x1p-10;    // of half precision, relative to all components
  constexpr double kSumRounding = 0x1p-9;  // of sums of 2^15 squares in single precision, relative to that of the mean
  if (windowOf(image) != windowOf(variances)) throw FileError("its pixels are not where those of its picture are");
  image.luminanceVariance.clear();
  for (std::size_t i = 0; i < variances.rgb.size(); ++i) {
    const glm::dvec3 variance(variances.rgb[i]);
    const double y = luminance(variance), mean = luminance(glm::dvec3(image.rgb[i]));
    const double size = std::abs(variance.r) + std::abs(variance.g) + std::abs(variance.b);
    if (!std::isfinite(y) || y < -(kRounding * size + kSumRounding * mean * mean)) {
      throw FileError("a variance of luminance is negative or not finite");
    }
    image.luminanceVariance.push_back(static_cast<float>(std::max(0.0, y)));
  }
}

}  // namespace candela::image
