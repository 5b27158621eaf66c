// Chooses the filter by --device.
#include "host/cli/denoise_film.h"

#include "host/cli/cached_device.h"
#include "host/core/errors.h"
#include "host/denoise/denoise.h"
#include "host/denoise/device_filter.h"
#include "host/denoise/reference_filter.h"
#include "host/verify/film_test.h"

namespace candela::cli {
namespace {

// The image joins those whose light is biased on purpose, which verdicts refuse.
void noteBias(image::Image& image) {
  std::string& bias = image.metadata[verify::kBiasMetadata];
  bias += (bias.empty() ? "" : "; ") + std::string("denoised: neighbours are averaged");
}

}  // namespace

void requireDenoisable(const Arguments& arguments) {
  if (!arguments.denoise || arguments.settings.image.integrator == render::Integrator::path) return;
  throw UsageError("--denoise: only the path tracer has the statistics that it needs; use --integrator path");
}

void requireDenoisable(const RenderJob& job) {
  if (!job.arguments.denoise || job.settings.image.sampleCount >= 2) return;
  throw UsageError("--denoise needs at least two samples per pixel; state --spp 2 or more");
}

Arguments withDenoiseLayers(Arguments arguments) {
  if (arguments.denoise) arguments.settings.image.layers.add(image::Layer::moments);
  return arguments;
}

void denoiseImage(image::Image& image, const image::Film& film, const Arguments& arguments, const Log& log) {
  denoise::requireStatistics(film);
  if (arguments.device == "cpu") {
    denoise::denoise(image, film, denoise::filterByReference);
  } else {
    CachedDevice cached(arguments, log);
    denoise::denoise(image, film, [&](const denoise::PixelStatistics& statistics) {
      return denoise::filterOnDevice(cached.device(), statistics);
    });
  }
  noteBias(image);
}

}  // namespace candela::cli
