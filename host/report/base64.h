// Bytes as text within HTML.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "host/image/image.h"

namespace candela::report {

/// RFC 4648, section 4, with padding.
std::string base64(std::span<const std::byte> bytes);

/// A PNG file as the address of an image: "data:image/png;base64,...".
std::string pngUri(const image::Pixels8& pixels);

/// Red, green and blue of every pixel, row by row from the top, as binary32, little-endian, in base64.
std::string floatText(const image::Image& image);

}  // namespace candela::report
