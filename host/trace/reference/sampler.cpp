// The three kinds of random numbers.
#include "host/trace/reference/sampler.h"

#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kKeySeed = 0x5f356495u;  // separates the keys of permutations from random numbers
constexpr std::uint32_t kMaxStrataPerSide = 256;

std::uint32_t integerSquareRoot(std::uint32_t x) {
  std::uint64_t root = 0;
  while ((root + 1) * (root + 1) <= x && root < kMaxStrataPerSide) ++root;
  return static_cast<std::uint32_t>(root);
}

// The stratification of a dimension: alone, or as one of a pair that has a common key and an n x n grid.
struct Stratification {
  bool paired = false;
  bool second = false;    // of the pair
  std::uint32_t keySlot;  // slot of the pair's first dimension, or its own
};

Stratification stratificationOf(std::uint32_t dimension) {
  const std::uint32_t slot = dimension % 4;
  const auto pairFrom = [&](std::uint32_t first, std::uint32_t name) {
    return Stratification{true, name != first, (slot + first - name) % 4};
  };
  if (dimension < kCameraDimensionCount) {
    if (dimension == kDimensionFilterX || dimension == kDimensionFilterY) return pairFrom(kDimensionFilterX, dimension);
    if (dimension == kDimensionLensU || dimension == kDimensionLensV) return pairFrom(kDimensionLensU, dimension);
    return {false, false, slot};
  }
  if (dimension / kEnvironmentDimensions == 1) {
    return pairFrom(slot < kDimensionTexelX ? kDimensionTapX : kDimensionTexelX, slot);
  }
  const std::uint32_t name = (dimension - kCameraDimensionCount) % kVertexDimensionCount;
  if (name == kDimensionLightU || name == kDimensionLightV) return pairFrom(kDimensionLightU, name);
  if (name == kDimensionBsdfU || name == kDimensionBsdfV) return pairFrom(kDimensionBsdfU, name);
  return {false, false, slot};
}

}  // namespace

Words pcg4d(Words v) {
  const auto mix = [&v] {
    v[0] += v[1] * v[3];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
    v[3] += v[1] * v[2];
  };
  for (std::uint32_t& word : v) word = word * 1664525u + 1013904223u;
  mix();
  for (std::uint32_t& word : v) word ^= word >> 16;
  mix();
  return v;
}

Sampler::Sampler(render::SamplerKind kind, std::uint32_t seed, std::uint32_t sampleCount)
    : kind_(kind), seed_(seed), strataPerSide_(integerSquareRoot(sampleCount)) {}

Words Sampler::group(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const {
  switch (kind_) {
    case render::SamplerKind::sobol:
      return sobolGroup(pixel, sample, group);
    case render::SamplerKind::stratified:
      return stratifiedGroup(pixel, sample, group);
    case render::SamplerKind::independent:
      break;
  }
  return pcg4d({pixel, sample, group, seed_});
}

Words Sampler::sobolGroup(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const {
  const Words keys = pcg4d({pixel, 0, group, seed_ ^ kKeySeed});
  const std::uint32_t indexKey = keys[0] ^ keys[1] ^ keys[2] ^ keys[3];
  const std::uint32_t index = reverseBits(owenPermutation(reverseBits(sample), indexKey));
  Words words;
  for (std::uint32_t slot = 0; slot < 4; ++slot) {
    words[slot] = reverseBits(owenPermutation(reverseBits(sobolPoint(index, slot)), keys[slot]));
  }
  return words;
}

Words Sampler::stratifiedGroup(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const {
  const Words jitter = pcg4d({pixel, sample, group, seed_});
  const std::uint32_t n = strataPerSide_;
  if (n < 2 || sample >= n * n) return jitter;

  const Words keys = pcg4d({pixel, 1, group, seed_ ^ kKeySeed});
  Words words;
  for (std::uint32_t slot = 0; slot < 4; ++slot) {
    const Stratification way = stratificationOf(4 * group + slot);
    const std::uint32_t cell = permute(sample, n * n, keys[way.keySlot]);
    if (way.paired) {
      words[slot] = jitterInStratum(way.second ? cell / n : cell % n, n, jitter[slot]);
    } else {
      words[slot] = jitterInStratum(cell, n * n, jitter[slot]);
    }
  }
  return words;
}

std::uint32_t SampleNumbers::word(std::uint32_t dimension) {
  const std::uint32_t wanted = dimension / 4;
  if (wanted != group_) {
    const auto compute = [&] { return sampler_.group(pixel_, sample_, wanted); };
    words_ = cache_ ? cache_->at(wanted, compute) : compute();
    group_ = wanted;
  }
  return words_[dimension % 4];
}

}  // namespace candela::reference
