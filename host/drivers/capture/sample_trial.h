// Renders one sample of a few pixels on a device that records its work, and compares it with what is expected.
#pragma once
#include <memory>
#include <optional>

#include "host/drivers/capture/capture.h"
#include "host/image/film.h"
#include "host/trace/render/renderer.h"
#include "host/trace/vulkan/device.h"

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

}  // namespace candela::capture
