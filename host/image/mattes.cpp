// Counts of ids.
#include "host/image/mattes.h"

#include <algorithm>

#include "host/image/murmur_hash.h"

namespace candela::image {

void addIds(IdCounts& counts, const IdCount& samples) {
  if (samples.count == 0) return;
  const auto found = std::ranges::lower_bound(counts, samples.id, {}, &IdCount::id);
  if (found != counts.end() && found->id == samples.id) {
    found->count += samples.count;
  } else {
    counts.insert(found, samples);
  }
}

void addIds(IdCounts& counts, const IdCounts& samples) {
  for (const IdCount& term : samples) addIds(counts, term);
}

std::uint32_t sampleCountOf(const IdCounts& counts) {
  std::uint32_t sum = 0;
  for (const IdCount& entry : counts) sum += entry.count;
  return sum;
}

std::uint32_t matteId(std::string_view name) {
  constexpr std::uint32_t kExponentBits = 255;
  const std::uint32_t hash = murmurHash3(name);
  const std::uint32_t exponent = hash >> 23 & kExponentBits;
  const bool isNormal = exponent != 0 && exponent != kExponentBits;
  return isNormal ? hash : hash ^ 1u << 23;
}

}  // namespace candela::image
