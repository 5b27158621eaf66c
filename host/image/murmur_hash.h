// MurmurHash3 of 32 bits, by which Cryptomatte identifies names.
#pragma once
#include <cstdint>
#include <string_view>

namespace candela::image {

/// Returns MurmurHash3_x86_32 (Austin Appleby, 2011) of the bytes of a text.
std::uint32_t murmurHash3(std::string_view text, std::uint32_t seed = 0);

}  // namespace candela::image
