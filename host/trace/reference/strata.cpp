// Permutations of strata, and points in strata.
#include <bit>

#include "host/trace/reference/sampler.h"

namespace candela::reference {
namespace {

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

}  // namespace

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

}  // namespace candela::reference
