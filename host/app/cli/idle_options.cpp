// The table of options that only some renders read.
#include "host/app/cli/idle_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/base/file_extension.h"
#include "host/image/image.h"

namespace candela::cli {
namespace {

bool usesIntegrator(const OptionUse& use, render::Integrator integrator) {
  return use.settings.image.integrator == integrator;
}

bool usesAccel(const OptionUse& use, render::AccelKind accel) { return use.settings.structure.accel == accel; }

bool usesEnvironment(const OptionUse& use) { return !use.arguments.loadOptions.environment.source.empty(); }

bool usesDevice(const OptionUse& use) { return use.onDevice; }

bool usesReference(const OptionUse& use) { return use.onReference; }

bool showsImages(const OptionUse& use) { return use.showsImages; }

bool buildsDeviceBvh(const OptionUse& use) { return use.onDevice && usesAccel(use, render::AccelKind::bvh); }

bool hasAlphaChannel(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return file == "-" || extension == ".png" || extension == ".exr";
}

// Options that have an effect only on some renders.
struct SpecialOption {
  const char* option;
  bool (*isRead)(const OptionUse& use);
  const char* reader;
};
constexpr const char* kDeviceReader = "Vulkan devices";
constexpr std::array kSpecialOptions{
    SpecialOption{"--nee", [](const OptionUse& use) { return usesIntegrator(use, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{"--rr-start", [](const OptionUse& use) { return usesIntegrator(use, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{
        "--aov-through-specular",
        [](const OptionUse& use) { return use.choosesLayers || !withSums(use.settings.image.layers).isEmpty(); },
        "renders with --aov or --denoise"},
    SpecialOption{"--max-depth", [](const OptionUse& use) { return !isView(use.settings.image.integrator); },
                  "--integrator path or whitted"},
    SpecialOption{"--light-size", [](const OptionUse& use) { return usesIntegrator(use, render::Integrator::whitted); },
                  "--integrator whitted"},
    SpecialOption{"--ao-distance", [](const OptionUse& use) { return usesIntegrator(use, render::Integrator::ao); },
                  "--integrator ao"},
    SpecialOption{"--grid-density", [](const OptionUse& use) { return usesAccel(use, render::AccelKind::grid); },
                  "--accel grid"},
    SpecialOption{"--layout", buildsDeviceBvh, "Vulkan devices with --accel bvh"},
    SpecialOption{"--bvh-split", [](const OptionUse& use) { return usesAccel(use, render::AccelKind::bvh); },
                  "--accel bvh"},
    SpecialOption{"--bvh-quality",
                  [](const OptionUse& use) {
                    return buildsDeviceBvh(use) && use.settings.structure.bvhSplit == render::BvhSplit::sah;
                  },
                  "Vulkan devices with --accel bvh and --bvh-split sah"},
    SpecialOption{"--kernel",
                  [](const OptionUse& use) { return usesDevice(use) && usesIntegrator(use, render::Integrator::path); },
                  "Vulkan devices with --integrator path"},
    SpecialOption{"--loads", usesDevice, kDeviceReader},
    SpecialOption{"--workgroup", usesDevice, kDeviceReader},
    SpecialOption{"--segments-per-dispatch", usesDevice, kDeviceReader},
    SpecialOption{"--hang-timeout", usesDevice, kDeviceReader},
    SpecialOption{"--fallback", usesDevice, kDeviceReader},
    SpecialOption{"--threads", usesReference, "the reference tracer (--device cpu)"},
    SpecialOption{"--env-rotate", usesEnvironment, "the environment of --env"},
    SpecialOption{"--env-scale", usesEnvironment, "the environment of --env"},
    SpecialOption{"--tonemap", showsImages, "PNG and JPEG files"},
    SpecialOption{"--exposure", showsImages, "PNG and JPEG files"}};

}  // namespace

void noteIdleOptions(const OptionUse& use, const Log& log) {
  for (const auto& [option, isRead, reader] : kSpecialOptions) {
    if (isRead(use) || !use.arguments.given.contains(option)) continue;
    log.note(fmt::format("{} has no effect here; it applies to {}", option, reader));
  }
}

void noteLostAlpha(const RenderArguments& arguments, const Log& log) {
  const bool hasOther = arguments.outputs.empty() || !arguments.film.checkpoint.empty() || arguments.displayServer;
  if (arguments.request.image.backdrop != render::Backdrop::none || hasOther) return;
  if (std::ranges::any_of(arguments.outputs, hasAlphaChannel)) return;
  log.note(
      "--background none: JPEG, HDR and PFM files have no alpha, so that the background is black in them; write a "
      "PNG or EXR file");
}

}  // namespace candela::cli
