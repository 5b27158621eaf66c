// Adds samples to the sums of layers.
#include <algorithm>
#include <cmath>

#include "host/image/fixed_sum.h"
#include "host/image/layers.h"

namespace candela::image {
namespace {

// Truncates a value towards 0 and limits it to the range of the film. Sets `bad` if the limit changes it.
FixedSum toSignedFixed(double value, bool& bad) {
  if (!std::isfinite(value)) {
    bad = true;
    return {};
  }
  bad = bad || std::abs(value) > kFilmMaximum;
  const FixedSum magnitude = toFixed(std::min(std::abs(value), kFilmMaximum));
  return value < 0 ? negated(magnitude) : magnitude;
}

// Returns the value that the film adds for a channel of a sample.
double keptOf(double whole) { return std::isfinite(whole) && whole >= 0 ? std::min(whole, kFilmMaximum) : 0; }

// Returns a part of the radiance, limited to the value that the film adds for the whole.
double partOf(double whole, double part) {
  const double kept = keptOf(whole);
  return part >= 0 ? std::min(part, kept) : 0;  // 0 also where it is not a number
}

/// Adds the channels of a sample to those sums of a pixel that it has.
class SampleAdder {
 public:
  SampleAdder(std::span<LayerRow> rows, std::uint32_t sums) : rows_(rows), sums_(sums) {}

  template <class Vector>
  void add(LayerSum sum, const Vector& value) {
    if ((sums_ & static_cast<std::uint32_t>(sum)) == 0) return;
    const std::uint32_t first = firstLayerRow(sums_, sum);
    for (int i = 0; i < Vector::length(); ++i) {
      addFixed(rows_[first + static_cast<std::uint32_t>(i)].words, toSignedFixed(value[i], bad_));
    }
  }
  bool foundBad() const { return bad_; }

 private:
  std::span<LayerRow> rows_;
  std::uint32_t sums_;
  bool bad_ = false;
};

glm::dvec3 partOf(const glm::dvec3& whole, const glm::dvec3& part) {
  return {partOf(whole.x, part.x), partOf(whole.y, part.y), partOf(whole.z, part.z)};
}

}  // namespace

void addLayerRows(std::span<LayerRow> sums, std::span<const LayerRow> terms) {
  if (sums.empty()) return;
  for (std::size_t i = 0; i < 3; ++i) sums[0].words[i] += terms[0].words[i];
  for (std::size_t row = 1; row < sums.size(); ++row) addFixed(sums[row].words, terms[row].words);
}

void addLayerSample(std::span<LayerRow> rows, std::uint32_t sums, const LayerSample& sample,
                    const glm::dvec3& radiance) {
  SampleAdder adder(rows, sums);
  if (sample.hit) {
    adder.add(LayerSum::normal, sample.hit->normal);
    adder.add(LayerSum::albedo, sample.hit->albedo);
    adder.add(LayerSum::depth, glm::dvec1(sample.hit->depth));
    adder.add(LayerSum::position, sample.hit->position);
    adder.add(LayerSum::texCoord, sample.hit->texCoord);
    adder.add(LayerSum::albedoSquared, glm::dvec1(dot(sample.hit->albedo, sample.hit->albedo)));
  }
  adder.add(LayerSum::unscattered, partOf(radiance, sample.unscattered.value_or(radiance)));
  adder.add(LayerSum::scatteredOnce, partOf(radiance, sample.scatteredOnce.value_or(radiance)));
  adder.add(LayerSum::rootRadiance, sqrt(glm::dvec3(keptOf(radiance.x), keptOf(radiance.y), keptOf(radiance.z))));
  rows[0].words[0] += sample.hit ? 1 : 0;
  rows[0].words[1] += adder.foundBad() ? 1 : 0;
}

}  // namespace candela::image
