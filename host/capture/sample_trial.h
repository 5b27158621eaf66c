// Renders one sample of a few pixels repeatedly, with smaller settings and scenes, to find a small case that still
// fails.
#pragma once
#include <memory>
#include <optional>

#include "host/capture/capture.h"
#include "host/capture/scene_parts.h"
#include "host/image/film.h"
#include "host/render/renderer.h"
#include "host/vulkan/device.h"

namespace candela::capture {

/// The samples of a trial: sample `index` of each pixel of the settings' window.
struct Sample {
  render::RenderSettings settings;
  std::uint32_t index = 0;
};

/// A device, and the options of its pipelines: see DeviceOptions.
struct TrialDevice {
  vulkan::DeviceInfo info;
  std::uint32_t subgroupSize = 0;
  vulkan::PrepareShader prepareShader{};
};

class SampleTrial {
 public:
  /// Opens the devices. `other` is the one whose bits are expected; absent: the reference's values are. Throws
  /// NoDeviceError.
  SampleTrial(const TrialDevice& device, const std::optional<TrialDevice>& other);

  /// Returns how many values of the film differ from the expected ones, of which there may be none. Throws as
  /// Renderer::prepare() does.
  std::size_t differing(const scene::Scene& scene, const Sample& sample);
  /// Returns whether a value differs; false if the scene cannot be rendered.
  bool fails(const scene::Scene& scene, const Sample& sample);
  /// Returns the work on the device and the expected values: one dispatch, unless the kernel consists of several, or
  /// gives another result in one. Throws as Renderer::prepare() does.
  Capture capture(const scene::Scene& scene, const Sample& sample);

 private:
  ExpectedValues expectedOf(const scene::Scene& scene, const Sample& sample);
  image::Film render(const scene::Scene& scene, const Sample& sample);

  vulkan::DeviceInfo info_;
  std::shared_ptr<vulkan::Recording> recording_;
  std::unique_ptr<render::Renderer> device_;
  std::unique_ptr<render::Renderer> expected_;  ///< the reference, or the other device
  bool expectsBits_;
};

/// Returns the smallest workgroup, region and number of segments at which the sample of the pixel still fails: first
/// one pixel in a workgroup of one invocation, then one in the settings' workgroup, then all pixels of its workgroup.
/// If none fails, the first is returned.
Sample smallestSample(SampleTrial& trial, const scene::Scene& scene, const render::RenderSettings& settings,
                      const render::PixelSample& sample);

/// Returns the parts of a scene without which the sample does not fail.
Subset smallestScene(SampleTrial& trial, const SceneParts& parts, const Sample& sample,
                     const std::function<bool()>& stop);

}  // namespace candela::capture
