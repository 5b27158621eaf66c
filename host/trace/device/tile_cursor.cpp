// Iterates over an image in rectangles.
#include "host/trace/device/tile_cursor.h"

#include <algorithm>

#include "host/base/divide_up.h"

namespace candela::device {
namespace {

/// Splits `length` into the minimum number of nearly equal parts that are multiples of `step` and, if possible, at most
/// `maximum`, and returns the first one.
std::uint32_t evenPart(std::uint32_t length, std::uint32_t step, std::uint64_t maximum) {
  if (maximum >= length) return length;
  const std::uint64_t steps = divideUp<std::uint64_t>(length, step);
  const std::uint64_t stepsAtMost = std::max<std::uint64_t>(1, maximum / step);
  const std::uint64_t parts = divideUp(steps, stepsAtMost);
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(length, divideUp(steps, parts) * step));
}

}  // namespace

TileCursor TileCursor::ofTiles(render::Extent image, render::Extent tile) {
  TileCursor cursor(image, tile);
  cursor.isTiled_ = true;
  return cursor;
}

void TileCursor::moveTo(std::uint32_t row) {
  x_ = 0;
  y_ = std::min(row, image_.height - 1) / step_.height * step_.height;
}

Rect TileCursor::next(std::uint64_t pixelsWanted) {
  const std::uint32_t rowsLeft = image_.height - y_;
  const std::uint32_t stripHeight = std::min(step_.height, rowsLeft);
  if (isTiled_) return advance(std::min(step_.width, image_.width - x_), stripHeight);
  const std::uint64_t rowsWanted = pixelsWanted / image_.width;
  if (x_ == 0 && rowsWanted >= stripHeight) return advance(image_.width, evenPart(rowsLeft, step_.height, rowsWanted));
  return advance(evenPart(image_.width - x_, step_.width, pixelsWanted / stripHeight), stripHeight);
}

Rect TileCursor::advance(std::uint32_t width, std::uint32_t height) {
  const Rect rect{x_, y_, width, height};
  x_ += width;
  if (x_ < image_.width) return rect;
  x_ = 0;
  y_ += height;
  if (y_ == image_.height) y_ = 0;
  return rect;
}

}  // namespace candela::device
