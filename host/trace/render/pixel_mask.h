// A set of the pixels of a film.
#pragma once
#include <vector>

namespace candela::render {

/// An entry for each pixel of a film, row by row from the top. Empty: all pixels.
using PixelMask = std::vector<bool>;

inline bool isSelected(const PixelMask& mask, std::size_t pixel) { return mask.empty() || mask[pixel]; }

}  // namespace candela::render
