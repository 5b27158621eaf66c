// Rectangles of pixels in the plane of a picture.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

namespace candela::image {

/// Columns from `x` and rows from `y`, which count downwards. The edges fit in 32 bits with a sign.
struct PixelBox {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;

  bool isEmpty() const { return width <= 0 || height <= 0; }
  bool contains(const PixelBox& box) const {
    return box.x >= x && box.y >= y && box.x + box.width <= x + width && box.y + box.height <= y + height;
  }
  bool operator==(const PixelBox&) const = default;
};

/// Returns the pixels that are in both; isEmpty() if there are none.
inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  const std::int64_t x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::min(a.x + a.width, b.x + b.width) - x, std::min(a.y + a.height, b.y + b.height) - y};
}

/// Returns "X,Y,WIDTH,HEIGHT", as --crop takes it.
std::string boxText(const PixelBox& box);

}  // namespace candela::image
