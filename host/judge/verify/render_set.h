// Several renders of one picture with different random numbers, of which only the means of regions and of pixels are
// kept.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "host/base/statistics/permutation.h"
#include "host/image/image.h"
#include "host/judge/verify/regions.h"

namespace candela::verify {

class RenderSet {
 public:
  /// Adds a render. Throws FileError, without the name of the file, if its pixels are display-referred or not finite,
  /// or if they are not in the window and frame of the renders before it.
  void add(const image::Image& render);

  std::size_t count() const { return means_.size(); }
  const image::PixelBox& window() const { return window_; }
  const image::PixelBox& frame() const { return frame_; }
  /// Returns "the size 640x480", or the window and the frame if they differ.
  std::string placeText() const;
  /// Those of regionsOf().
  const std::vector<Region>& regions() const { return regions_; }
  /// One row for each render, with the means of all regions.
  const statistics::Rows& means() const { return means_; }
  /// The least precise of the files.
  std::uint32_t significandBits() const { return significandBits_; }
  /// Returns the index of a render before the last one whose means are all equal to those of the last one: it has the
  /// same random numbers.
  std::optional<std::size_t> twinOfLast() const;
  /// Returns the mean of all renders.
  image::Image mean() const;

 private:
  void requireUsable(const image::Image& render) const;

  image::PixelBox window_, frame_;
  std::vector<Region> regions_;
  statistics::Rows means_;
  std::uint32_t significandBits_ = 24;
  std::vector<glm::dvec3> sums_;
};

}  // namespace candela::verify
