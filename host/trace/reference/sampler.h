// Random numbers as a function of seed, pixel, sample and dimension: docs/light-transport.md section 1. All operations
// are on integers, so that every device agrees bit for bit.
#pragma once
#include <array>
#include <cstdint>

#include "host/trace/render/settings.h"

namespace candela::reference {

using Words = std::array<std::uint32_t, 4>;

/// The hash pcg4d of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020.
Words pcg4d(Words v);

/// The Laine-Karras permutation with Burley's constants: an Owen scramble of a word with reversed bits (Burley,
/// "Practical Hash-based Owen Scrambling", JCGT 2020).
std::uint32_t owenPermutation(std::uint32_t reversedBits, std::uint32_t key);

/// Returns the word with its bits in the opposite order.
std::uint32_t reverseBits(std::uint32_t word);

/// Returns point `index` of Sobol dimension `slot` + 1, unscrambled, with the direction numbers of Joe and Kuo. `slot`
/// in 0..3.
std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t slot);

/// Returns the image of `i` under the permutation `key` of 0 .. length-1 (Kensler, Pixar memo 13-01). 1 <= length,
/// i < length.
std::uint32_t permute(std::uint32_t i, std::uint32_t length, std::uint32_t key);

/// Returns a word whose value / 2^32 is in [stratum / count, (stratum + 1) / count), at the fraction `jitter` / 2^32 of
/// it.
std::uint32_t jitterInStratum(std::uint32_t stratum, std::uint32_t count, std::uint32_t jitter);

/// Returns the word as a real number in [0, 1): its upper 24 bits.
inline double toUnit(std::uint32_t word) { return (word >> 8) * 0x1p-24; }

/// The parameters that are common to all samples of a render.
class Sampler {
 public:
  Sampler(render::SamplerKind kind, std::uint32_t seed, std::uint32_t sampleCount);
  /// Returns the words of dimensions 4 * group .. 4 * group + 3.
  Words group(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const;

 private:
  Words sobolGroup(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const;
  Words stratifiedGroup(std::uint32_t pixel, std::uint32_t sample, std::uint32_t group) const;

  render::SamplerKind kind_;
  std::uint32_t seed_;
  std::uint32_t strataPerSide_;
};

/// The words of recent groups of one sample, for replicas of it.
class NumberCache {
 public:
  /// Returns the words of `group`, which `compute()` gives the first time.
  template <class Compute>
  const Words& at(std::uint32_t group, Compute compute) {
    Entry& entry = entries_[group % entries_.size()];
    if (entry.group != group) entry = {group, compute()};
    return entry.words;
  }

 private:
  struct Entry {
    std::uint32_t group = ~0u;
    Words words{};
  };
  std::array<Entry, 32> entries_;
};

/// The numbers of one sample of one pixel. Caches the words of the last requested group.
class SampleNumbers {
 public:
  /// `cache`, unless null, is used only for this sample, and must outlive the object.
  SampleNumbers(const Sampler& sampler, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                NumberCache* cache = nullptr)
      : sampler_(sampler), cache_(cache), pixel_(x + 65536u * y), sample_(sample) {}

  std::uint32_t word(std::uint32_t dimension);
  double unit(std::uint32_t dimension) { return toUnit(word(dimension)); }

  std::uint32_t pixel() const { return pixel_; }
  std::uint32_t sample() const { return sample_; }

 private:
  static constexpr std::uint32_t kNoGroup = ~0u;

  const Sampler& sampler_;
  NumberCache* cache_;
  std::uint32_t pixel_;
  std::uint32_t sample_;
  std::uint32_t group_ = kNoGroup;
  Words words_{};
};

}  // namespace candela::reference
