// Checks a job before its session is prepared, which takes time.
#include "host/job/job.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"
#include "host/job/memory_need.h"
#include "host/trace/device/kernel.h"
#include "host/trace/render/request.h"

namespace candela::job {
namespace {

void requirePixelLimit(const render::Extent& size) {
  if (std::uint64_t{size.width} * size.height <= image::kMaxImagePixels) return;
  throw FileError(fmt::format("an image of {}x{} pixels exceeds the limit of {} pixels", size.width, size.height,
                              image::kMaxImagePixels));
}

void requireCropWithin(const render::ImageSettings& image) {
  if (!image.crop || isWithin(*image.crop, image.size)) return;
  throw UsageError(
      fmt::format("the crop {} is not within the image of {} pixels", windowText(*image.crop), extentText(image.size)));
}

void requireAdaptable(const render::ImageSettings& image, const FilmPolicy& film) {
  if (!film.noiseThreshold) return;
  const std::uint32_t pilot = render::pilotSamples(*film.noiseThreshold);
  if (image.sampleCount <= pilot) {
    throw UsageError(
        fmt::format("with a noise threshold of {}, every pixel gets at least {} samples; set {}, the maximum, above {}",
                    *film.noiseThreshold, pilot, settingWords("spp"), pilot));
  }
  if (film.samples) {
    throw UsageError(fmt::format(
        "with a noise threshold, only all samples together decide where to stop, so that a render cannot have a part "
        "of them; divide the image with {} instead",
        settingWords("crop")));
  }
  if (image.crop) render::requireAligned(*image.crop, image.size);
}

}  // namespace

void requireSamples(const render::SampleRange& range, std::uint32_t total) {
  if (range.end <= total) return;
  throw UsageError(fmt::format("samples {}:{} exceed the {} samples per pixel; set the total with {}", range.first,
                               range.end, total, settingWords("spp")));
}

render::SampleRange samplesOf(const Job& job) {
  const std::uint32_t total = job.settings.image.sampleCount;
  const render::SampleRange range = job.film.samples.value_or(render::SampleRange{0, total});
  requireSamples(range, total);
  return range;
}

std::optional<render::AdaptivePlan> planOf(const Job& job) {
  if (!job.film.noiseThreshold) return std::nullopt;
  const render::ImageSettings& image = job.settings.image;
  return render::AdaptivePlan(image.window(), *job.film.noiseThreshold, image.sampleCount);
}

void requirePossible(const scene::Scene& scene, const render::RenderSettings& settings, const FilmPolicy& film,
                     bool makesPictures) {
  device::requireKernel(settings);
  render::requireIntegrator(scene, settings);
  requirePixelLimit(settings.image.size);
  requireCropWithin(settings.image);
  requireAdaptable(settings.image, film);
  requireMemoryForRender(scene, settings.image, settings.structure, makesPictures);
}

}  // namespace candela::job
