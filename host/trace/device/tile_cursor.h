// Iterates over an image in rectangles, so that each sweep covers every pixel once.
#pragma once
#include <cstdint>

#include "host/trace/render/extent.h"

namespace candela::device {

/// Pixels x .. x + width - 1 by y .. y + height - 1.
struct Rect {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Sweeps over `image` from top to bottom, repeatedly. The size of the rectangles may change from one to the next.
class TileCursor {
 public:
  /// Rectangles are whole workgroups, except at the right and lower edge. All extents must be > 0.
  TileCursor(render::Extent image, render::Extent workgroup) : image_(image), step_(workgroup) {}
  /// Every rectangle is one `tile`, cut only at the right and lower edge.
  static TileCursor ofTiles(render::Extent image, render::Extent tile);

  /// Returns the next rectangle, of at most `pixelsWanted` pixels (but at least one workgroup): a strip over the full
  /// width if that has few enough pixels, else a part of a strip that is one workgroup high. The rest of a strip or of
  /// the image is divided evenly, so that no small remainder comes last.
  Rect next(std::uint64_t pixelsWanted);
  /// Continues at the left edge of the strip of workgroups or tiles that contains this row of the image.
  void moveTo(std::uint32_t row);
  /// First row of the next rectangle.
  std::uint32_t row() const { return y_; }
  /// Returns whether the next rectangle is the first of a sweep.
  bool isAtStart() const { return x_ == 0 && y_ == 0; }

 private:
  Rect advance(std::uint32_t width, std::uint32_t height);

  render::Extent image_;
  render::Extent step_;   ///< rectangles are multiples of it
  bool isTiled_ = false;  ///< rectangles are exactly step_
  /// The start of the next rectangle. Everything above it is done, and so is everything left of it within step_.height.
  std::uint32_t x_ = 0, y_ = 0;
};

}  // namespace candela::device
