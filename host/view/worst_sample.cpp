// Replays samples on both sides.
#include "host/view/worst_sample.h"

#include <algorithm>

namespace candela::view {
namespace {

constexpr std::uint32_t kSearchedSamples = 64;

}  // namespace

std::uint32_t worstSample(render::SampleReplayer& device, render::SampleReplayer& reference, render::PixelSample sample,
                          std::uint32_t count) {
  double worst = -1;
  std::uint32_t found = 0;
  for (sample.index = 0; sample.index < std::clamp(count, 1u, kSearchedSamples); ++sample.index) {
    const glm::dvec3 radiance = device.replay(sample).path.radiance;
    const double apart = glm::distance(radiance, reference.replay(sample).path.radiance);
    if (apart <= worst) continue;
    worst = apart;
    found = sample.index;
  }
  return found;
}

}  // namespace candela::view
