// Finds a small case in which a sample still fails.
#pragma once
#include <functional>

#include "host/drivers/capture/sample_trial.h"
#include "host/drivers/capture/scene_parts.h"

namespace candela::capture {

/// Returns the smallest workgroup, region and number of segments at which the sample of the pixel still fails: first
/// one pixel in a workgroup of one invocation, then one in the settings' workgroup, then all pixels of its workgroup.
/// If none fails, the first is returned.
Sample smallestSample(SampleTrial& trial, const scene::Scene& scene, const render::RenderSettings& settings,
                      const render::PixelSample& sample);

/// Returns the parts of a scene without which the sample does not fail.
Subset smallestScene(SampleTrial& trial, const SceneParts& parts, const Sample& sample,
                     const std::function<bool()>& stop);

}  // namespace candela::capture
