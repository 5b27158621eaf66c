// Mixes four bytes at a time, then the rest.
#include "host/image/murmur_hash.h"

#include <bit>

namespace candela::image {
namespace {

std::uint32_t wordAt(std::string_view text, std::size_t first, std::size_t count) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < count; ++i) {
    word |= std::uint32_t{static_cast<unsigned char>(text[first + i])} << (8 * i);
  }
  return word;
}

std::uint32_t scrambled(std::uint32_t word) { return std::rotl(word * 0xcc9e2d51u, 15) * 0x1b873593u; }

std::uint32_t finished(std::uint32_t hash) {
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

}  // namespace

std::uint32_t murmurHash3(std::string_view text, std::uint32_t seed) {
  std::uint32_t hash = seed;
  const std::size_t whole = text.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    hash = std::rotl(hash ^ scrambled(wordAt(text, i, 4)), 13) * 5 + 0xe6546b64u;
  }
  hash ^= scrambled(wordAt(text, whole, text.size() - whole));
  return finished(hash ^ static_cast<std::uint32_t>(text.size()));
}

}  // namespace candela::image
