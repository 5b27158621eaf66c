// Compiles the kernels of scenes on a device.
#pragma once
#include <optional>

#include "host/drivers/kernels/kernel_report.h"
#include "host/scene/scene.h"
#include "host/trace/device/scene_kernels.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device.h"

namespace candela::kernels {

class KernelReporter {
 public:
  /// Opens the device for a `selector` of vulkan::selectDevice(), which need not have memory. Throws NoDeviceError.
  explicit KernelReporter(const std::string& selector);

  const vulkan::DeviceInfo& device() const { return device_.info(); }
  /// Returns a row for each module of the kernel that a session with these settings would use. Throws as
  /// device::kernelsOf() and vulkan::reportPipeline() do.
  std::vector<KernelRow> rowsOf(const scene::Scene& scene, render::RenderSettings settings);

 private:
  KernelRow rowOf(const device::SceneKernels& kernels, std::size_t module);

  vulkan::Device device_;
  render::SceneLoads fastestLoads_;
  std::optional<double> maxInvocations_;  ///< that the device has in flight; empty: the driver does not report them
};

}  // namespace candela::kernels
