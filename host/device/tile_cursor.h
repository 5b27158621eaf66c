// Walks over an image in rectangles, so that each sweep covers every pixel once.
#pragma once
#include <cstdint>

#include "host/render/extent.h"

namespace candela::device {

/// Pixels x .. x + width - 1 by y .. y + height - 1.
struct Rect {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Sweeps over `image` from top to bottom, again and again. The size of the pieces may change from one to the next.
class TileCursor {
 public:
  /// Pieces are whole workgroups except at the right and lower edge. All extents > 0.
  TileCursor(render::Extent image, render::Extent workgroup) : image_(image), step_(workgroup) {}
  /// Every piece is one `tile`, cut only at the right and lower edge.
  static TileCursor ofTiles(render::Extent image, render::Extent tile);

  /// The next piece, of at most `pixelsWanted` pixels (but never less than a workgroup): strips over the full width if
  /// that is enough for them, else pieces of a strip that is one workgroup high. What is left of a strip or of the
  /// image is divided evenly, so that no small remainder comes last.
  Rect next(std::uint64_t pixelsWanted);
  /// First row of the next piece.
  std::uint32_t row() const { return y_; }
  /// Whether the next piece is the first of a sweep.
  bool isAtStart() const { return x_ == 0 && y_ == 0; }

 private:
  Rect advance(std::uint32_t width, std::uint32_t height);

  render::Extent image_;
  render::Extent step_;   ///< pieces are multiples of it
  bool isTiled_ = false;  ///< pieces are exactly step_
  std::uint32_t x_ = 0,
                y_ = 0;  ///< where the next piece begins; all above and, within step_.height, left of it is done
};

}  // namespace candela::device
