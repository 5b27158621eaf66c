// Indices of refraction by channel, and their mixture.
#include "host/trace/reference/dispersion.h"

#include <algorithm>

namespace candela::reference {

ChannelChoice chooseChannel(const dvec3& throughput, double number) {
  const double sum = throughput.x + throughput.y + throughput.z;
  const dvec3 probabilities = sum > 0 ? throughput / sum : dvec3(0, 1, 0);
  if (number < probabilities.x) return {0, probabilities};
  const bool isGreen = number < probabilities.x + probabilities.y || probabilities.z == 0;
  return {isGreen ? std::size_t{1} : std::size_t{2}, probabilities};
}

scene::SurfaceParameters inChannel(const scene::SurfaceParameters& surface, std::size_t channel) {
  constexpr std::array kSides{-1.0, 0.0, 1.0};
  const double halfSpread = (double{surface.ior} - 1) * double{surface.transmissionDispersionScale} / 40;
  scene::SurfaceParameters result = surface;
  result.ior = static_cast<float>(std::max(1.0, surface.ior + kSides[channel] * halfSpread));
  return result;
}

DispersiveBsdf::DispersiveBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone,
                               const ChannelChoice& choice)
    : choice_(choice),
      channels_{SurfaceBsdf(inChannel(surface, 0), wo, outside, isCoatAlone),
                SurfaceBsdf(inChannel(surface, 1), wo, outside, isCoatAlone),
                SurfaceBsdf(inChannel(surface, 2), wo, outside, isCoatAlone)} {}

}  // namespace candela::reference
