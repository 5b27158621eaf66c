// Reads files as 8-bit pixels, as they are displayed.
#pragma once
#include <filesystem>

#include "host/image/image.h"

namespace candela::image {

/// Returns the pixels of readImage() as sRGB signals of 8 bits, over black.
inline Pixels8 readPixels8(const std::filesystem::path& file) { return toPixels8(readImage(file), {}); }

}  // namespace candela::image
