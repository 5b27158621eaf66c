// The meaning of `auto` on a device: the result of `candela tune`, or the built-in choice.
#pragma once
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "host/app/cli/arguments.h"
#include "host/app/cli/cached_device.h"
#include "host/measure/tune/tuning_file.h"
#include "host/trace/device/device_memory.h"
#include "host/trace/device/gpu_renderer.h"
#include "host/trace/render/renderer.h"

namespace candela::cli {

/// The result stored for a device in the user's cache. A file that must not be used causes a warning and is not
/// changed.
struct KeptTuning {
  tune::Tuning tuning;
  std::filesystem::path file;
};
std::optional<KeptTuning> keptTuning(const vulkan::DeviceInfo& info, const Log& log);

/// Returns the stored result, or the built-in choice if there is none or `--untuned` is given.
render::AutomaticChoices automaticChoices(const TracingArguments& arguments, const vulkan::DeviceInfo& info,
                                          const Log& log);

/// Renders on a device with these choices, and logs the warnings of sessions, each once.
class TunedRenderer final : public render::Renderer {
 public:
  TunedRenderer(std::unique_ptr<CachedDevice> device, render::AutomaticChoices choices, const Log& log)
      : device_(std::move(device)),
        renderer_(device::makeGpuRenderer(device_->device())),
        choices_(std::move(choices)),
        log_(log) {}

  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    render::RenderSettings tuned = settings;
    tuned.execution.automatic = choices_;
    std::unique_ptr<render::Session> session = renderer_->prepare(scene, tuned);
    for (const std::string& warning : session->statistics().warnings) {
      if (warned_.insert(warning).second) log_.warning(warning);
    }
    if (const std::uint64_t bytes = device::predictedMemory(*session); bytes > 0)
      log_.detail(fmt::format("about {} MiB of memory will be used", bytes >> 20));
    return session;
  }

 private:
  std::unique_ptr<CachedDevice> device_;
  std::unique_ptr<render::Renderer> renderer_;
  render::AutomaticChoices choices_;
  const Log& log_;
  std::set<std::string> warned_;
};

}  // namespace candela::cli
