// Sizes and rectangles in pixels or invocations.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace candela::scene {

struct Extent {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const Extent&) const = default;
};

/// Returns for example "512x384".
inline std::string extentText(const Extent& extent) { return fmt::format("{}x{}", extent.width, extent.height); }

/// Pixels x .. x + width - 1 by y .. y + height - 1 of an image; (0, 0) is its top left.
struct Window {
  std::uint32_t x = 0, y = 0;
  std::uint32_t width = 0, height = 0;

  Extent extent() const { return {width, height}; }
  bool operator==(const Window&) const = default;
};

/// All pixels of an image.
constexpr Window windowOf(const Extent& size) { return {0, 0, size.width, size.height}; }

/// Returns whether `inner` lies within an image of this size.
constexpr bool isWithin(const Window& inner, const Extent& size) {
  return inner.x <= size.width && inner.width <= size.width - inner.x && inner.y <= size.height &&
         inner.height <= size.height - inner.y;
}

/// E.g. "128,0,64,64": X, Y, width and height.
inline std::string windowText(const Window& window) {
  return fmt::format("{},{},{},{}", window.x, window.y, window.width, window.height);
}

}  // namespace candela::scene
