// The 64-bit FNV-1a hash, and a mixing function for 64-bit words.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace candela {

/// Continues `hash` over `bytes` (Fowler, Noll and Vo).
inline std::uint64_t fnv1a(std::span<const std::uint8_t> bytes, std::uint64_t hash = 0xcbf29ce484222325ull) {
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ull;
  return hash;
}

/// Continues `hash` over the four bytes of `word`, the lowest first.
inline std::uint64_t fnv1aOfWord(std::uint32_t word, std::uint64_t hash) {
  for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (word >> shift & 0xffu)) * 0x100000001b3ull;
  return hash;
}

/// Continues `hash` over the bytes of `text`.
inline std::uint64_t fnv1aOfText(std::string_view text, std::uint64_t hash = fnv1a({})) {
  return fnv1a({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, hash);
}

/// The increment of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014).
inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15u;

/// The finaliser of SplitMix64, a permutation of all words.
inline std::uint64_t splitMix(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

}  // namespace candela
