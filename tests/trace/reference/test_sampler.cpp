// The reference's random numbers, compared with vectors that sampler_vectors.py prints, and with published points.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

#include "host/trace/reference/sampler.h"
#include "shaders/shared/dimensions.h"

using namespace candela;
using namespace candela::reference;

namespace {

constexpr std::uint32_t kPixel = 3 + 65536 * 2;

Sampler samplerOf(render::SamplerKind kind, std::uint32_t sampleCount) { return Sampler(kind, 7, sampleCount); }

// Pearson's statistic of counts that should be equal.
double chiSquare(const std::vector<int>& counts) {
  double total = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  double sum = 0;
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

}  // namespace

TEST_CASE("pcg4d gives the vectors of an independent calculation") {
  CHECK(pcg4d({0, 0, 0, 0}) == Words{0x0f02f829u, 0x2d568769u, 0x32b0c43bu, 0xd32548eau});
  CHECK(pcg4d({1, 2, 3, 4}) == Words{0x3622cd16u, 0xf11471d8u, 0xe1109b3fu, 0x02b94c2fu});
}

TEST_CASE("each kind of sampler gives the vectors of an independent calculation") {
  CHECK(samplerOf(render::SamplerKind::independent, 9).group(kPixel, 5, 1) ==
        Words{0x39931ab3u, 0xc779ce87u, 0xe9f21e79u, 0x034b49cbu});
  CHECK(samplerOf(render::SamplerKind::sobol, 9).group(kPixel, 5, 1) ==
        Words{0xc1ab4811u, 0x4a016864u, 0x641e13afu, 0x44121275u});
  CHECK(Sampler(render::SamplerKind::sobol, ~0u, 1).group(65534 + 65536u * 65534, 70000, 9999) ==
        Words{0x0a0da4e2u, 0xad01e9bfu, 0xc00033e9u, 0x9f9cb2dau});
  const Sampler stratified = samplerOf(render::SamplerKind::stratified, 9);
  CHECK(stratified.group(kPixel, 5, 0) == Words{0xc646e9ddu, 0xcc4324a2u, 0xcd3b224eu, 0x5857e3b1u});
  CHECK(stratified.group(kPixel, 5, 2) == Words{0x0c0fc945u, 0xd46a0f31u, 0xc7e262b9u, 0x6225f969u});
  CHECK(stratified.group(kPixel, 5, 3) == Words{0xaf808fc4u, 0x59bc937cu, 0xf1499debu, 0x873c20a5u});
}

TEST_CASE("Sobol points before scrambling are those published by Joe and Kuo") {
  // In Gray code order, the order of their generator.
  const double published[8][4] = {{0, 0, 0, 0},
                                  {0.5, 0.5, 0.5, 0.5},
                                  {0.75, 0.25, 0.25, 0.25},
                                  {0.25, 0.75, 0.75, 0.75},
                                  {0.375, 0.375, 0.625, 0.875},
                                  {0.875, 0.875, 0.125, 0.375},
                                  {0.625, 0.125, 0.875, 0.625},
                                  {0.125, 0.625, 0.375, 0.125}};
  for (std::uint32_t n = 0; n < 8; ++n) {
    for (std::uint32_t slot = 0; slot < 4; ++slot) {
      INFO("point " << n << ", dimension " << slot + 1);
      CHECK(sobolPoint(n ^ (n >> 1), slot) * 0x1p-32 == published[n][slot]);
    }
  }
}

TEST_CASE("each interval of length 2^-k contains one number of any 2^k scrambled Sobol samples") {
  const Sampler sampler(render::SamplerKind::sobol, 3, 64);
  for (std::uint32_t slot = 0; slot < 4; ++slot) {
    std::set<std::uint32_t> intervals;
    for (std::uint32_t sample = 0; sample < 64; ++sample) intervals.insert(sampler.group(42, sample, 5)[slot] >> 26);
    CHECK(intervals.size() == 64);
  }
}

TEST_CASE("2^k scrambled Sobol samples of the first two dimensions of a group fill every elementary interval once") {
  const Sampler sampler(render::SamplerKind::sobol, 3, 64);
  for (std::uint32_t bits = 0; bits <= 6; ++bits) {
    std::set<std::uint64_t> cells;
    for (std::uint32_t sample = 0; sample < 64; ++sample) {
      const Words words = sampler.group(42, sample, 5);
      const std::uint64_t x = std::uint64_t{words[0]} >> (32 - bits);
      const std::uint64_t y = std::uint64_t{words[1]} >> (26 + bits);
      cells.insert((x << 32) | y);
    }
    INFO("x in 2^" << bits << " intervals");
    CHECK(cells.size() == 64);
  }
}

TEST_CASE("permute is a permutation") {
  const std::vector<std::uint32_t> ofTen{1, 9, 2, 0, 7, 4, 3, 6, 8, 5};  // key 12345
  for (std::uint32_t i = 0; i < 10; ++i) CHECK(permute(i, 10, 12345) == ofTen[i]);

  for (const std::uint32_t length : {1u, 2u, 3u, 4u, 9u, 16u, 25u, 100u, 1000u, 65536u}) {
    for (const std::uint32_t key : {0u, 1u, 0x80000000u, 0xdeadbeefu}) {
      std::vector<bool> taken(length);
      std::uint32_t distinct = 0;
      for (std::uint32_t i = 0; i < length; ++i) {
        const std::uint32_t place = permute(i, length, key);
        REQUIRE(place < length);
        if (!taken[place]) ++distinct;
        taken[place] = true;
      }
      INFO("length " << length << ", key " << key);
      CHECK(distinct == length);
    }
  }
}

TEST_CASE("the numbers of a stratum span the stratum and no more") {
  // 2^32 / 3 = 1431655765.33, so strata start at 0, 1431655765, 2863311530.
  CHECK(jitterInStratum(0, 3, 0) == 0u);
  CHECK(jitterInStratum(0, 3, 0xffffffffu) == 1431655764u);
  CHECK(jitterInStratum(1, 3, 0) == 1431655765u);
  CHECK(jitterInStratum(2, 3, 0) == 2863311530u);
  CHECK(jitterInStratum(2, 3, 0xffffffffu) == 0xffffffffu);
  CHECK(jitterInStratum(1, 2, 0x80000000u) == 0xc0000000u);
}

TEST_CASE("stratified samples fill every stratum exactly once") {
  constexpr std::uint32_t kSide = 5;
  const std::uint32_t vertex = kCameraDimensionCount + 3 * kVertexDimensionCount;
  const std::vector<std::uint32_t> pairs{kDimensionFilterX, kDimensionLensU, vertex + kDimensionLightU,
                                         vertex + kDimensionBsdfU};
  const std::vector<std::uint32_t> singles{kDimensionLensV + 1, vertex + kDimensionLightChoice, vertex + kDimensionLobe,
                                           vertex + kDimensionRoulette};
  const Sampler sampler(render::SamplerKind::stratified, 11, kSide * kSide);
  std::vector<std::set<double>> cells(pairs.size() + singles.size());
  for (std::uint32_t sample = 0; sample < kSide * kSide; ++sample) {
    SampleNumbers numbers(sampler, 12, 34, sample);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      cells[i].insert(std::floor(kSide * numbers.unit(pairs[i])) +
                      kSide * std::floor(kSide * numbers.unit(pairs[i] + 1)));
    }
    for (std::size_t i = 0; i < singles.size(); ++i) {
      cells[pairs.size() + i].insert(std::floor(kSide * kSide * numbers.unit(singles[i])));
    }
  }
  for (const auto& taken : cells) CHECK(taken.size() == kSide * kSide);
}

TEST_CASE("samples beyond the last full square of strata are independent") {
  const Sampler stratified = samplerOf(render::SamplerKind::stratified, 11);  // n = 3
  const Sampler independent = samplerOf(render::SamplerKind::independent, 11);
  CHECK(stratified.group(kPixel, 8, 0) != independent.group(kPixel, 8, 0));
  CHECK(stratified.group(kPixel, 9, 0) == independent.group(kPixel, 9, 0));
  CHECK(samplerOf(render::SamplerKind::stratified, 3).group(kPixel, 0, 0) == independent.group(kPixel, 0, 0));
  // 257 x 257 samples: only 256 x 256 are stratified.
  const Sampler large = samplerOf(render::SamplerKind::stratified, 66049);
  CHECK(large.group(kPixel, 65535, 0) != independent.group(kPixel, 65535, 0));
  CHECK(large.group(kPixel, 65536, 0) == independent.group(kPixel, 65536, 0));
}

TEST_CASE("every sampler's numbers are uniform over pixels") {
  for (const render::SamplerKind kind :
       {render::SamplerKind::independent, render::SamplerKind::sobol, render::SamplerKind::stratified}) {
    const Sampler sampler(kind, 1, 16);
    std::vector<int> first(64), pair(256);
    for (std::uint32_t i = 0; i < 40000; ++i) {
      SampleNumbers numbers(sampler, i % 200, i / 200, i % 16);
      const double u = numbers.unit(kDimensionFilterX);
      const double v = numbers.unit(kDimensionFilterY);
      REQUIRE(u >= 0);
      REQUIRE(u < 1);
      ++first[static_cast<std::size_t>(64 * u)];
      ++pair[static_cast<std::size_t>(16 * u) + 16 * static_cast<std::size_t>(16 * v)];
    }
    // Quantiles of chi-square at 1 - 1e-4: 63 degrees of freedom 111, 255 degrees 348.
    CHECK(chiSquare(first) < 111);
    CHECK(chiSquare(pair) < 348);
  }
}

TEST_CASE("a unit number is made from the word's upper 24 bits") {
  CHECK(toUnit(0) == 0);
  CHECK(toUnit(0xff) == 0);
  CHECK(toUnit(0x80000000u) == 0.5);
  CHECK(toUnit(0xffffffffu) == 1 - 0x1p-24);
}
