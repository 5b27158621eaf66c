// What the cases of one child process share: the open device and the two tracers.
#pragma once
#include <memory>
#include <optional>

#include "host/render/renderer.h"
#include "host/vulkan/device.h"

namespace candela::conformance {

class Workbench {
 public:
  /// `recording` receives everything that the devices of open() are given; null: nothing is recorded.
  explicit Workbench(vulkan::DeviceInfo info, std::shared_ptr<vulkan::Recording> recording = {});

  const vulkan::DeviceInfo& info() const { return info_; }
  /// Opens the device with these options.
  vulkan::Device open(vulkan::DeviceOptions options) const;
  /// Returns the device, which the first call opens without optional features.
  vulkan::Device& device();
  /// Returns the device renderer on device().
  render::Renderer& renderer();
  /// Returns the reference tracer.
  render::Renderer& reference() { return *reference_; }

 private:
  vulkan::DeviceInfo info_;
  std::shared_ptr<vulkan::Recording> recording_;
  std::optional<vulkan::Device> device_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::Renderer> reference_;
};

}  // namespace candela::conformance
