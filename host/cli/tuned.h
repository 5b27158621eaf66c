// The meaning of `auto` on a device: the result of `candela tune`, or the built-in choice.
#pragma once
#include <memory>
#include <optional>

#include "host/cli/arguments.h"
#include "host/render/replay.h"
#include "host/tune/tuning_file.h"

namespace candela::cli {

/// The result stored for a device in the user's cache. A file that must not be used causes a warning and is not
/// changed.
struct KeptTuning {
  tune::Tuning tuning;
  std::filesystem::path file;
};
std::optional<KeptTuning> keptTuning(const vulkan::DeviceInfo& info, const Log& log);

/// Returns the stored result, or the built-in choice if there is none or `--untuned` is given.
render::AutomaticChoices automaticChoices(const Arguments& arguments, const vulkan::DeviceInfo& info, const Log& log);

/// Renders with another renderer and these choices.
class TunedRenderer final : public render::ReplayingRenderer {
 public:
  TunedRenderer(std::unique_ptr<render::ReplayingRenderer> renderer, render::AutomaticChoices choices)
      : renderer_(std::move(renderer)), choices_(std::move(choices)) {}

  render::RenderResult render(const scene::Scene& scene, const render::RenderSettings& settings,
                              const render::RenderControl& control) override {
    return renderer_->render(scene, tuned(settings), control);
  }
  render::Replay replay(const scene::Scene& scene, const render::RenderSettings& settings,
                        const render::PixelSample& sample) override {
    return renderer_->replay(scene, tuned(settings), sample);
  }

 private:
  render::RenderSettings tuned(render::RenderSettings settings) const {
    settings.automatic = choices_;
    return settings;
  }

  std::unique_ptr<render::ReplayingRenderer> renderer_;
  render::AutomaticChoices choices_;
};

}  // namespace candela::cli
