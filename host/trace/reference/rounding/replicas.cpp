// Compares replicas with the exact sample.
#include "host/trace/reference/rounding/replicas.h"

#include <algorithm>
#include <cmath>

#include "host/base/hash.h"
#include "host/image/film.h"
#include "host/trace/reference/sampler.h"

namespace candela::reference {
namespace {

double amplificationAt(const std::vector<TrailVertex>& a, const std::vector<TrailVertex>& b, std::size_t vertex) {
  const double travelled = vertex > 0 ? length(a[vertex].origin - a[vertex - 1].origin) : 0;
  const double scale = std::max(maxNorm(a[vertex].origin), travelled);
  const double apart = length(a[vertex].origin - b[vertex].origin) / (scale > 0 ? scale : 1);
  return std::max(apart, length(a[vertex].direction - b[vertex].direction)) / kRoundoff;
}

// Returns how many times farther apart the rays of a vertex are than one rounding of the coordinates on the path puts
// them: the angle between them times the longest segment between two hits, and the distance of their origins, both in
// units of the largest coordinate or distance of the path.
double growthAt(const std::vector<TrailVertex>& a, const std::vector<TrailVertex>& b, std::size_t vertex) {
  double scale = 0;
  double reach = 0;
  for (std::size_t i = 0; i <= vertex + 1 && i < a.size(); ++i) {
    const double travelled = i > 0 ? length(a[i].origin - a[i - 1].origin) : 0;
    scale = std::max({scale, maxNorm(a[i].origin), travelled});
    if (i > 1) reach = std::max(reach, travelled);
  }
  const double turned = reach * length(a[vertex].direction - b[vertex].direction);
  const double apart = std::max(length(a[vertex].origin - b[vertex].origin), turned);
  return scale > 0 ? apart / (scale * kRoundoff) : 0;
}

render::Replica compare(const RecordedArithmetic& exact, const RecordedArithmetic& replica, const dvec3& radiance) {
  const std::vector<TrailVertex>& a = exact.trail();
  const std::vector<TrailVertex>& b = replica.trail();
  const std::size_t count = std::min(a.size(), b.size());
  std::size_t next = 1;  // the first vertex that is reached by other decisions
  while (next < count && a[next].decisions == b[next].decisions) ++next;
  const bool same = next == count && a.size() == b.size() && exact.decisions() == replica.decisions();
  return {radiance, replica.decisions(), same ? 0 : static_cast<std::uint32_t>(next),
          static_cast<float>(amplificationAt(a, b, next - 1)), static_cast<float>(growthAt(a, b, next - 1))};
}

glm::dvec4 withLuminance(const dvec3& rgb) { return {rgb, image::luminance(rgb)}; }

void add(const render::Replica& replica, const dvec3& exact, render::Deviation& deviation) {
  const glm::dvec4 difference = withLuminance(replica.radiance - exact);
  deviation.undecided += replica.vertex > 0 ? 1 : 0;
  if (replica.growth > kAmplified) {
    deviation.amplified += 1;
    deviation.drift += difference;
  } else {
    deviation.magnitude += glm::abs(difference);
    deviation.lean += difference;
  }
}

}  // namespace

dvec3 ReplicaTracer::trace(const render::PixelSample& sample, std::uint32_t count, Counters& counters,
                           SampleOutputs outputs, render::Deviation& deviation, render::Replica* replicas) const {
  Counters uncounted;
  NumberCache cache;
  RecordedArithmetic exact;
  const dvec3 radiance = tracer_.sample(sample, counters, outputs, exact, &cache);
  for (std::uint32_t i = 0; i < count; ++i) {
    RoundedArithmetic rounded = arithmeticOf(sample, i);
    const dvec3 value = tracer_.sample(sample, uncounted, nullptr, rounded, &cache);
    const render::Replica replica = compare(exact, rounded, value);
    if (i == 0) add(replica, radiance, deviation);
    if (replicas) replicas[i] = replica;
  }
  return radiance;
}

render::Replica ReplicaTracer::trace(const render::PixelSample& sample, std::uint32_t index) const {
  Counters uncounted;
  NumberCache cache;
  RecordedArithmetic exact;
  tracer_.sample(sample, uncounted, nullptr, exact, &cache);
  RoundedArithmetic rounded = arithmeticOf(sample, index);
  return compare(exact, rounded, tracer_.sample(sample, uncounted, nullptr, rounded, &cache));
}

RoundedArithmetic ReplicaTracer::arithmeticOf(const render::PixelSample& sample, std::uint32_t index) const {
  const std::uint32_t number = index + 1;
  const Words words = pcg4d({sample.x + 65536u * sample.y, sample.index, tracer_.seed(), number});
  return {tracing_, (std::uint64_t{words[0]} << 32 | words[1]) + number * kSplitMixStep};
}

}  // namespace candela::reference
