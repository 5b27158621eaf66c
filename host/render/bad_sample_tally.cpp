// Counts bad samples and remembers the first pixels that have some.
#include "host/render/bad_sample_tally.h"

namespace candela::render {

void BadSampleTally::add(const image::Film& film, const RenderSettings& settings) {
  for (std::size_t i = 0; i < film.pixels().size(); ++i) {
    const image::FilmPixel& pixel = film.pixels()[i];
    if (pixel.badCount == 0) continue;
    samples_ += pixel.badCount;
    isBad_.resize(film.pixels().size());
    if (isBad_[i]) continue;
    isBad_[i] = true;
    pixels_ += 1;
    if (firstPixels_.size() == kPixelsKept) continue;
    firstPixels_.push_back({static_cast<std::uint32_t>(i % film.width()), static_cast<std::uint32_t>(i / film.width()),
                            pixel.badCount, pixel.firstBadSample - 1, settings.seed, settings.sampleCount});
  }
}

}  // namespace candela::render
