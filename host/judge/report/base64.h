// Base64 encodings for HTML.
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "host/image/image.h"

namespace candela::report {

/// Encodes as RFC 4648, section 4, with padding.
std::string base64(std::span<const std::byte> bytes);

/// Returns a PNG file as the URL of an image: "data:image/png;base64,...".
std::string pngUri(const image::Pixels8& pixels);

/// Returns red, green and blue of every pixel, row by row from the top, as binary32, little-endian, in base64.
std::string floatText(const image::Image& image);

}  // namespace candela::report
