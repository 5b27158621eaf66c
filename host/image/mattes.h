// Mattes: how many samples of a pixel hit which object or material, as exact counts. docs/layers.md.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace candela::image {

/// The kinds of things that ids identify. Each kind is a separate layer.
enum class MatteKind : std::uint8_t { object, material };
inline constexpr std::array kMatteKinds{MatteKind::object, MatteKind::material};

/// The id of samples that hit nothing. No name has it.
inline constexpr std::uint32_t kNoId = 0;

/// The number of samples of a pixel with an id.
struct IdCount {
  std::uint32_t id = kNoId;
  std::uint32_t count = 0;

  auto operator<=>(const IdCount&) const = default;
};

/// The counts of a pixel, by rising ids, none of them 0. Their sum is the number of the pixel's samples.
using IdCounts = std::vector<IdCount>;

/// Adds samples of one id.
void addIds(IdCounts& counts, const IdCount& samples);
/// Adds the counts of other samples of the same pixel.
void addIds(IdCounts& counts, const IdCounts& samples);
/// Returns the sum of the counts.
std::uint32_t sampleCountOf(const IdCounts& counts);

/// Returns the id of a name as the Cryptomatte specification 1.2 computes it: its MurmurHash3 (32 bits, seed 0), with
/// one bit of the exponent inverted where the bits would not be those of a normal number of binary32.
std::uint32_t matteId(std::string_view name);

/// Names with their ids, indexed by MatteKind, sorted, each once.
using MatteNames = std::array<std::vector<std::string>, kMatteKinds.size()>;

}  // namespace candela::image
