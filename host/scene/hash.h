// The 64-bit FNV-1a hash.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace candela::scene {

/// Continues `hash` over `bytes` (Fowler, Noll and Vo).
inline std::uint64_t fnv1a(std::span<const std::uint8_t> bytes, std::uint64_t hash = 0xcbf29ce484222325ull) {
  for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3ull;
  return hash;
}

/// Continues `hash` over the bytes of `text`.
inline std::uint64_t fnv1aOfText(std::string_view text, std::uint64_t hash = fnv1a({})) {
  return fnv1a({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, hash);
}

}  // namespace candela::scene
