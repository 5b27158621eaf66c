// Chooses the filter by --device.
#include "host/app/cli/denoise_film.h"

#include <fmt/format.h>

#include "host/app/cli/bias_text.h"
#include "host/app/cli/cached_device.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/trace/denoise/denoise.h"
#include "host/trace/denoise/device_filter.h"
#include "host/trace/denoise/oidn.h"
#include "host/trace/denoise/reference_filter.h"

namespace candela::cli {
namespace {

// A finished render is not lost with its device: the host denoises it instead. `candela denoise` has a file that is not
// lost, and needs a device that can be opened.
std::vector<glm::vec3> filterOnDevice(const denoise::PixelStatistics& statistics, const OpenDeviceArguments& device,
                                      bool isOfRender, const Log& log) {
  const auto filterOnHost = [&](const Error& error) {
    log.warning(fmt::format("{}; the image is denoised on the host instead", error.what()));
    return filterByReference(statistics);
  };
  try {
    CachedDevice cached(device, log);
    return denoise::filterOnDevice(cached.device(), statistics);
  } catch (const DeviceLostError& error) {
    return filterOnHost(error);
  } catch (const OutOfMemoryError& error) {
    return filterOnHost(error);
  } catch (const NoDeviceError& error) {
    if (!isOfRender) throw;
    return filterOnHost(error);
  }
}

// A finished render is not lost with the library, either. Returns false, with a warning, if it fails.
bool denoiseByOidn(image::Image& image, const image::Film& film, const Log& log) try {
  denoise::denoiseByOidn(image, film);
  addBias(image.metadata, "denoised by a neural network");
  return true;
} catch (const NoDeviceError& error) {
  log.warning(fmt::format("{}; the image is denoised by the statistics of its pixels instead", error.what()));
  return false;
}

void reportLimited(const denoise::LimitedLight& limited, image::Image& image, const Log& log) {
  const std::string text = fmt::format(
      "isolated bright samples in {} of {} pixels were limited, which removed {:.2g} % of the light",
      limited.pixelCount, image.rgb.size(), 100 * limited.removedFraction);
  addBias(image.metadata, text);
  log.note(text + "; add samples to keep it");
}

void denoisePicture(image::Image& image, const image::Film& film, bool byOidn, const OpenDeviceArguments& device,
                    bool isOfRender, const Log& log) {
  if (byOidn && denoiseByOidn(image, film, log)) return;
  const denoise::LimitedLight limited = denoise::denoise(image, film, [&](const denoise::PixelStatistics& statistics) {
    return device.usesReference() ? filterByReference(statistics) : filterOnDevice(statistics, device, isOfRender, log);
  });
  addBias(image.metadata, "denoised: neighbours are averaged");
  if (limited.pixelCount > 0) reportLimited(limited, image, log);
}

}  // namespace

void requireDenoisable(const RenderArguments& arguments) {
  if (arguments.denoisesByOidn) denoise::requireOidn();
  if (!arguments.denoise || arguments.request.image.integrator == render::Integrator::path) return;
  throw UsageError(fmt::format("only the path tracer has the statistics that denoising needs; use {}",
                               settingWords("integrator", "path")));
}

void requireDenoisable(const RenderArguments& arguments, const render::ImageSettings& image) {
  if (!arguments.denoise || image.sampleCount >= 2) return;
  throw UsageError(
      fmt::format("denoising needs at least two samples per pixel; use {} or more", settingWords("spp", "2")));
}

RenderArguments withDenoiseLayers(RenderArguments arguments) {
  if (arguments.denoise) arguments.request.image.layers.add(image::Layer::moments);
  return arguments;
}

void denoiseImage(image::Image& image, const image::Film& film, const DenoiseArguments& arguments, const Log& log) {
  denoisePicture(image, film, arguments.denoisesByOidn, arguments, false, log);
}

void denoiseResult(image::Image& image, const image::Film& film, bool isInterrupted, const RenderArguments& arguments,
                   const Log& log) {
  try {
    denoisePicture(image, film, arguments.denoisesByOidn, arguments, true, log);
  } catch (const UsageError& error) {
    if (!isInterrupted) throw;
    log.warning(fmt::format("the image is not denoised: {}", error.what()));
  }
}

}  // namespace candela::cli
