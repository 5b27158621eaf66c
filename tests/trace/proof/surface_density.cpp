// Compares counts of samples with the integrals of the density over cells.
#include "tests/trace/proof/surface_density.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <utility>

#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_samples.h"

namespace candela::proof {
namespace {

// Adds cells in which less than one sample is expected to the last cell: quadrature may not have a point where a cell
// reaches above the horizon.
void poolRare(std::vector<double>& expected, std::vector<double>& observed) {
  for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
    if (expected[i] >= 1) continue;
    expected.back() += std::exchange(expected[i], 0);
    observed.back() += std::exchange(observed[i], 0);
  }
}

// `observed` and `expected` have the samples and the quadrature of all cells.
void checkDensity(std::vector<double>& observed, std::vector<double>& expected) {
  const double total = std::accumulate(expected.begin(), expected.end(), 0.0);
  const double counted = std::accumulate(observed.begin(), observed.end(), 0.0);
  CHECK(total <= 1.0005 * kSurfaceSamples);  // quadrature
  for (double& share : expected) share *= std::min(1.0, kSurfaceSamples / total);
  expected.push_back(std::max(0.0, kSurfaceSamples - total));  // samples that end the path
  observed.push_back(kSurfaceSamples - counted);
  poolRare(expected, observed);
  checkCounts(observed, expected);
}

void checkWeight(const dvec3& mean, const dvec3& albedo) {
  for (int channel = 0; channel < 3; ++channel) {
    CAPTURE(channel, albedo[channel]);
    CHECK(mean[channel] == Approx(albedo[channel]).margin(2e-3));
  }
}

void append(const std::vector<double>& counts, std::vector<double>& all) {
  all.insert(all.end(), counts.begin(), counts.end());
}

std::vector<Scattered> samplesOf(const MaterialLeaves& leaves, const SurfaceCase& c,
                                 std::span<const glm::vec3> numbers) {
  return scattered(leaves, c.material, c.wo, numbers, c.outside, c.geometric);
}

}  // namespace

SurfaceNumbers::SurfaceNumbers()
    : samples(randomNumbers(kSurfaceSamples, 301)),
      coins(randomNumbers(kSurfaceSamples, 302)),
      lattice(latticeNumbers(50000)) {}

void checkSurface(const MaterialLeaves& leaves, const SurfaceCase& c, const SurfaceNumbers& numbers) {
  const std::vector<Scattered> samples = samplesOf(leaves, c, numbers.samples);
  std::vector<double> observed, expected;
  dvec3 albedo(0);
  for (const Half& half : halvesOf(c)) {
    const std::vector<ScatterValue> values = half.values(leaves);
    append(half.expected(values), expected);
    append(half.observed(samples, numbers.coins), observed);
    albedo += half.albedo(values);
  }
  checkDensity(observed, expected);
  checkWeight(meanWeight(samplesOf(leaves, c, numbers.lattice)), albedo);
}

}  // namespace candela::proof
