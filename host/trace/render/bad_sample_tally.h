// Counts the bad samples of films, over one render or many, and the pixels in which they occurred.
#pragma once
#include <cstdint>
#include <vector>

#include "host/image/film.h"
#include "host/trace/render/settings.h"

namespace candela::render {

/// A pixel of one render with bad samples: see FilmPixel::badCount.
struct BadPixel {
  std::uint32_t x = 0, y = 0;
  std::uint32_t badCount = 0;     ///< in that render
  std::uint32_t firstSample = 0;  ///< index of the first bad sample
  std::uint32_t seed = 0;         ///< of that render, which determines its samples
  std::uint32_t sampleCount = 0;

  bool operator==(const BadPixel&) const = default;
};

/// All renders that are added must be of images of the same size; each may be of another window.
class BadSampleTally {
 public:
  static constexpr std::size_t kPixelsKept = 5;

  /// Adds the bad samples of a film that was rendered with `image`.
  void add(const image::Film& film, const ImageSettings& image);

  /// Adds the counts of another tally, of later renders.
  void add(const BadSampleTally& later);

  std::uint64_t samples() const { return samples_; }
  /// Number of pixels with bad samples. A pixel counts once, even if it was bad in several renders.
  std::uint64_t pixels() const { return pixels_; }
  /// The first of these pixels, at most kPixelsKept: by render, then row by row from the top.
  const std::vector<BadPixel>& firstPixels() const { return firstPixels_; }

 private:
  bool note(std::uint32_t x, std::uint32_t y);

  Extent size_;  ///< of the images
  std::uint64_t samples_ = 0;
  std::uint64_t pixels_ = 0;
  std::vector<bool> isBad_;  ///< by pixel of the image; empty while no pixel is bad
  std::vector<BadPixel> firstPixels_;
};

/// The tallies of all renders of two tracers.
struct BadSampleTallies {
  BadSampleTally device, reference;

  std::uint64_t samples() const { return device.samples() + reference.samples(); }
  void add(const BadSampleTallies& later) {
    device.add(later.device);
    reference.add(later.reference);
  }
};

}  // namespace candela::render
