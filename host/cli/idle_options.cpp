// The table of options that only some renders read.
#include "host/cli/idle_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/core/file_extension.h"
#include "host/image/image.h"

namespace candela::cli {
namespace {

bool usesIntegrator(const Arguments& arguments, render::Integrator integrator) {
  return arguments.request.image.integrator == integrator;
}

bool usesAccel(const Arguments& arguments, render::AccelKind accel) { return arguments.request.accel == accel; }

bool usesEnvironment(const Arguments& arguments) { return !arguments.loadOptions.environment.source.empty(); }

bool usesDevice(const Arguments& arguments) { return !arguments.usesReference(); }

// All commands but `render` use the reference tracer, too.
bool usesReferenceThreads(const Arguments& arguments) {
  return arguments.usesReference() || arguments.command != Command::render ||
         arguments.film.fallback == job::Fallback::reference;
}

bool buildsDeviceBvh(const Arguments& arguments) {
  return usesDevice(arguments) && usesAccel(arguments, render::AccelKind::bvh);
}

// Comparisons and the viewer display images as well.
bool displaysImage(const Arguments& arguments) {
  return arguments.command != Command::render || std::ranges::any_of(arguments.outputs, image::isEightBit);
}

bool hasAlphaChannel(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return file == "-" || extension == ".png" || extension == ".exr";
}

// Options that have an effect only on some renders.
struct SpecialOption {
  const char* option;
  bool (*isRead)(const Arguments& arguments);
  const char* reader;
};
constexpr const char* kDeviceReader = "Vulkan devices";
constexpr std::array kSpecialOptions{
    SpecialOption{"--nee", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{"--rr-start", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::path); },
                  "--integrator path"},
    SpecialOption{"--aov-through-specular",
                  [](const Arguments& a) {
                    const bool mayShowLayers = a.command == Command::view;  // they are chosen in the window
                    return mayShowLayers || !withSums(a.request.image.layers).isEmpty();
                  },
                  "renders with --aov or --denoise"},
    SpecialOption{"--max-depth", [](const Arguments& a) { return !isView(a.request.image.integrator); },
                  "--integrator path or whitted"},
    SpecialOption{"--light-size", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::whitted); },
                  "--integrator whitted"},
    SpecialOption{"--ao-distance", [](const Arguments& a) { return usesIntegrator(a, render::Integrator::ao); },
                  "--integrator ao"},
    SpecialOption{"--grid-density", [](const Arguments& a) { return usesAccel(a, render::AccelKind::grid); },
                  "--accel grid"},
    SpecialOption{"--layout", buildsDeviceBvh, "Vulkan devices with --accel bvh"},
    SpecialOption{"--bvh-split", [](const Arguments& a) { return usesAccel(a, render::AccelKind::bvh); },
                  "--accel bvh"},
    SpecialOption{
        "--bvh-quality",
        [](const Arguments& a) { return buildsDeviceBvh(a) && a.request.structure.bvhSplit == render::BvhSplit::sah; },
        "Vulkan devices with --accel bvh and --bvh-split sah"},
    SpecialOption{"--kernel",
                  [](const Arguments& a) { return usesDevice(a) && usesIntegrator(a, render::Integrator::path); },
                  "Vulkan devices with --integrator path"},
    SpecialOption{"--loads", usesDevice, kDeviceReader},
    SpecialOption{"--workgroup", usesDevice, kDeviceReader},
    SpecialOption{"--segments-per-dispatch", usesDevice, kDeviceReader},
    SpecialOption{"--hang-timeout", usesDevice, kDeviceReader},
    SpecialOption{"--fallback", usesDevice, kDeviceReader},
    SpecialOption{"--threads", usesReferenceThreads, "the reference tracer (--device cpu)"},
    SpecialOption{"--env-rotate", usesEnvironment, "the environment of --env"},
    SpecialOption{"--env-scale", usesEnvironment, "the environment of --env"},
    SpecialOption{"--tonemap", displaysImage, "PNG and JPEG files"},
    SpecialOption{"--exposure", displaysImage, "PNG and JPEG files"}};

}  // namespace

void noteIdleOptions(const Arguments& arguments, const Log& log) {
  if (arguments.command == Command::bench) return;  // benchmarks choose the structures themselves
  for (const auto& [option, isRead, reader] : kSpecialOptions) {
    if (isRead(arguments) || !arguments.given.contains(option)) continue;
    log.note(fmt::format("{} has no effect here; it applies to {}", option, reader));
  }
}

void noteLostAlpha(const Arguments& arguments, const Log& log) {
  const bool hasOther = arguments.outputs.empty() || !arguments.film.checkpoint.empty() || arguments.displayServer;
  if (arguments.request.image.backdrop != render::Backdrop::none || hasOther) return;
  if (std::ranges::any_of(arguments.outputs, hasAlphaChannel)) return;
  log.note(
      "--background none: JPEG, HDR and PFM files have no alpha, so that the background is black in them; write a "
      "PNG or EXR file");
}

}  // namespace candela::cli
