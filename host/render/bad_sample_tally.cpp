// Adds up bad samples over renders.
#include "host/render/bad_sample_tally.h"

namespace candela::render {

// Marks the pixel as bad. Returns whether it had no bad sample before.
bool BadSampleTally::note(std::size_t pixel, std::size_t pixelCount) {
  isBad_.resize(pixelCount);
  if (isBad_[pixel]) return false;
  isBad_[pixel] = true;
  pixels_ += 1;
  return true;
}

void BadSampleTally::add(const image::Film& film, const ImageSettings& image) {
  window_ = image.window();
  for (std::size_t i = 0; i < film.pixels().size(); ++i) {
    const image::FilmPixel& pixel = film.pixels()[i];
    if (pixel.badCount == 0) continue;
    samples_ += pixel.badCount;
    if (!note(i, film.pixels().size()) || firstPixels_.size() == kPixelsKept) continue;
    firstPixels_.push_back({window_.x + static_cast<std::uint32_t>(i % film.width()),
                            window_.y + static_cast<std::uint32_t>(i / film.width()), pixel.badCount,
                            pixel.firstBadSample - 1, image.seed, image.sampleCount});
  }
}

void BadSampleTally::add(const BadSampleTally& later) {
  if (later.pixels_ == 0) return;
  window_ = later.window_;
  samples_ += later.samples_;
  for (const BadPixel& pixel : later.firstPixels_) {
    const bool isNew = note(std::size_t{pixel.y - window_.y} * window_.width + pixel.x - window_.x,
                            later.isBad_.size());
    if (isNew && firstPixels_.size() < kPixelsKept) firstPixels_.push_back(pixel);
  }
  for (std::size_t i = 0; i < later.isBad_.size(); ++i) {
    if (later.isBad_[i]) note(i, later.isBad_.size());
  }
}

}  // namespace candela::render
