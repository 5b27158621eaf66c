// PNG files without compression, for textures that are generated.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela::generate {

/// Returns the bytes of a PNG file (ISO/IEC 15948) with 8-bit RGB pixels, three bytes each, row by row from the top.
/// There are width * height pixels, at least one.
std::vector<std::byte> storedPng(std::uint32_t width, std::uint32_t height, const std::vector<std::byte>& rgb);

}  // namespace candela::generate
