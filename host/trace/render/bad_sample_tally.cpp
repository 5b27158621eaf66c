// Adds up bad samples over renders.
#include "host/trace/render/bad_sample_tally.h"

namespace candela::render {

// Marks the pixel as bad. Returns whether it had no bad sample before.
bool BadSampleTally::note(std::uint32_t x, std::uint32_t y) {
  isBad_.resize(std::size_t{size_.width} * size_.height);
  const std::size_t pixel = std::size_t{y} * size_.width + x;
  if (isBad_[pixel]) return false;
  isBad_[pixel] = true;
  pixels_ += 1;
  return true;
}

void BadSampleTally::add(const image::Film& film, const ImageSettings& image) {
  size_ = image.size;
  const Window window = image.window();
  for (std::size_t i = 0; i < film.pixels().size(); ++i) {
    const image::FilmPixel& pixel = film.pixels()[i];
    if (pixel.badCount == 0) continue;
    samples_ += pixel.badCount;
    const std::uint32_t x = window.x + static_cast<std::uint32_t>(i % film.width());
    const std::uint32_t y = window.y + static_cast<std::uint32_t>(i / film.width());
    if (!note(x, y) || firstPixels_.size() == kPixelsKept) continue;
    firstPixels_.push_back({x, y, pixel.badCount, pixel.firstBadSample - 1, image.seed, image.sampleCount});
  }
}

void BadSampleTally::add(const BadSampleTally& later) {
  if (later.pixels_ == 0) return;
  size_ = later.size_;
  samples_ += later.samples_;
  for (const BadPixel& pixel : later.firstPixels_) {
    if (note(pixel.x, pixel.y) && firstPixels_.size() < kPixelsKept) firstPixels_.push_back(pixel);
  }
  for (std::size_t i = 0; i < later.isBad_.size(); ++i) {
    if (later.isBad_[i]) {
      note(static_cast<std::uint32_t>(i % size_.width), static_cast<std::uint32_t>(i / size_.width));
    }
  }
}

}  // namespace candela::render
