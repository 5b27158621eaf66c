// Captures one sample of a scene, with as little of the scene as possible.
#pragma once
#include <functional>
#include <optional>

#include "host/drivers/capture/capture.h"
#include "host/drivers/capture/sample_trial.h"
#include "host/drivers/capture/scene_parts.h"

namespace candela::capture {

struct SceneRequest {
  render::RenderSettings settings;
  render::PixelSample sample{};
  TrialDevice device{};
  std::optional<TrialDevice> expect{};      ///< whose bits are expected; absent: the reference's values
  double shrinkSeconds = 60;                ///< time limit for removing parts of the scene; 0: the scene is not changed
  const std::atomic<bool>* stop = nullptr;  ///< polled
};

/// Renders the sample and returns its work. If the device fails, region, workgroup, path and scene are reduced as long
/// as it still fails. Throws UsageError if single precision cannot decide the sample, InterruptedError if `stop` became
/// true, and as Renderer::prepare() does.
Capture captureScene(const scene::Scene& scene, const SceneParts& parts, const SceneRequest& request);

}  // namespace candela::capture
