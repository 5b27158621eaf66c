// The objects that the cases of one child process share: the open device and the two tracers.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "host/drivers/conformance/observation.h"
#include "host/trace/render/renderer.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

class Workbench {
 public:
  /// All devices of open() have the recording, the preparation of shaders and `compilesOnly` of `common`.
  explicit Workbench(vulkan::DeviceInfo info, vulkan::DeviceOptions common = {});

  const vulkan::DeviceInfo& info() const { return info_; }
  /// Opens the device with these options, and those of the constructor.
  vulkan::Device open(vulkan::DeviceOptions options) const;
  /// Returns the device, which the first call opens without optional features.
  vulkan::Device& device();
  /// Returns the device renderer on device().
  render::Renderer& renderer();
  /// Returns the reference tracer.
  render::Renderer& reference() { return *reference_; }
  /// The observations with which cases compare theirs, by the name of their group.
  std::map<std::string, Observation>& observations() { return observations_; }

 private:
  vulkan::DeviceInfo info_;
  vulkan::DeviceOptions common_;
  std::optional<vulkan::Device> device_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::Renderer> reference_;
  std::map<std::string, Observation> observations_;
};

}  // namespace candela::conformance
