// The three kinds of random numbers.
#include "host/reference/sampler.h"

#include <bit>

#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kKeySeed = 0x5f356495u;  // separates the keys of permutations from random numbers
constexpr std::uint32_t kMaxStrataPerSide = 256;

constexpr std::uint32_t reverseBits(std::uint32_t x) {
  x = ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  return (x << 16) | (x >> 16);
}

// A primitive polynomial of Joe and Kuo's table new-joe-kuo-6.21201: degree s, coefficients a, initial numbers m.
struct SobolPolynomial {
  std::uint32_t degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 3> initial;
};
constexpr std::array<SobolPolynomial, 3> kPolynomials{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions sobolDirections(const SobolPolynomial& polynomial) {
  const std::uint32_t s = polynomial.degree;
  Directions v{};
  for (std::uint32_t b = 0; b < 32; ++b) {
    if (b < s) {
      v[b] = polynomial.initial[b] << (31 - b);
      continue;
    }
    v[b] = v[b - s] ^ (v[b - s] >> s);
    for (std::uint32_t k = 1; k < s; ++k) {
      if ((polynomial.coefficients >> (s - 1 - k)) & 1) v[b] ^= v[b - k];
    }
  }
  return v;
}

constexpr std::array<Directions, 3> kDirections{sobolDirections(kPolynomials[0]), sobolDirections(kPolynomials[1]),
                                                sobolDirections(kPolynomials[2])};

std::uint32_t integerSquareRoot(std::uint32_t x) {
  std::uint64_t root = 0;
  while ((root + 1) * (root + 1) <= x && root < kMaxStrataPerSide) ++root;
  return static_cast<std::uint32_t>(root);
}

// Returns the first 32-bit word in `stratum`: floor(stratum 2^32 / count); 2^32 for stratum == count.
std::uint64_t stratumStart(std::uint64_t stratum, std::uint64_t count) { return (stratum << 32) / count; }

std::uint32_t permuteRound(std::uint32_t i, std::uint32_t mask, std::uint32_t key) {
  i ^= key;
  i *= 0xe170893du;
  i ^= key >> 16;
  i ^= (i & mask) >> 4;
  i ^= key >> 8;
  i *= 0x0929eb3fu;
  i ^= key >> 23;
  i ^= (i & mask) >> 1;
  i *= 1 | (key >> 27);
  i *= 0x6935fa69u;
  i ^= (i & mask) >> 11;
  i *= 0x74dcb303u;
  i ^= (i & mask) >> 2;
  i *= 0x9e501cc3u;
  i ^= (i & mask) >> 2;
  i *= 0xc860a3dfu;
  i &= mask;
  return i ^ (i >> 5);
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

std::uint32_t owenPermutation(std::uint32_t x, std::uint32_t key) {
  x += key;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t slot) {
  if (slot == 0) return reverseBits(index);  // the van der Corput sequence
  std::uint32_t point = 0;
  for (; index != 0; index &= index - 1) {
    point ^= kDirections[slot - 1][static_cast<std::size_t>(std::countr_zero(index))];
  }
  return point;
}

std::uint32_t permute(std::uint32_t i, std::uint32_t length, std::uint32_t key) {
  const std::uint32_t mask = std::bit_ceil(length) - 1;
  int rounds = 0;
  do {
    i = permuteRound(i, mask, key);
  } while (i >= length && ++rounds < 32);
  return (i % length + key % length) % length;
}

std::uint32_t jitterInStratum(std::uint32_t stratum, std::uint32_t count, std::uint32_t jitter) {
  const std::uint64_t start = stratumStart(stratum, count);
  const std::uint64_t size = stratumStart(stratum + 1, count) - start;
  return static_cast<std::uint32_t>(start + ((jitter * size) >> 32));
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
