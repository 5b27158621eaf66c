// Advances a session by the steps that the plan of adaptive sampling returns.
#include "host/job/sample_loop.h"

namespace candela::job {
namespace {

// Number of samples that pixels outside of the mask lack.
std::uint64_t samplesLeftOut(const image::Film& film, const render::PixelMask& mask, std::uint32_t sampleEnd) {
  std::uint64_t samples = 0;
  for (std::size_t i = 0; i < film.pixels().size(); ++i) {
    if (!render::isSelected(mask, i)) samples += sampleEnd - film.pixels()[i].sampleCount;
  }
  return samples;
}

}  // namespace

bool SampleLoop::trace(const render::SampleRange& range, FilmProgress& progress) {
  const render::RenderControl control{&watch_.stop(), [&](double, std::uint64_t samples) { progress.update(samples); }};
  while (!session_.advance(range, control)) {
    if (watch_.mustEnd()) return false;
    progress.endOfCall();
    const bool mustWrite = watch_.mustWrite();
    watch_.resume();
    pause_(mustWrite);
  }
  progress.endOfCall();
  return true;
}

bool SampleLoop::traceAdaptively(const render::AdaptivePlan& plan, std::uint32_t maxSamples, FilmProgress& progress) {
  image::Film film = session_.film();
  while (const std::optional<render::AdaptiveStep> step = plan.next(film)) {
    session_.restrictTo(step->pixels);
    progress.skip(samplesLeftOut(film, step->pixels, maxSamples));
    if (step->indivisible > 0) {
      decided_ = std::move(film);
      if (!trace({0, step->indivisible}, progress)) return false;
      decided_.reset();
    }
    if (!trace({0, step->sampleEnd}, progress)) return false;
    film = session_.film();
  }
  return true;
}

}  // namespace candela::job
