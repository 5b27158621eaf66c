// Opens the device when it is first needed.
#include "host/drivers/conformance/workbench.h"

#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::conformance {

Workbench::Workbench(vulkan::DeviceInfo info, std::shared_ptr<vulkan::Recording> recording,
                     vulkan::PrepareShader prepareShader)
    : info_(std::move(info)),
      recording_(std::move(recording)),
      prepareShader_(std::move(prepareShader)),
      reference_(reference::makeReferenceRenderer()) {}

vulkan::Device Workbench::open(vulkan::DeviceOptions options) const {
  options.recording = recording_;
  options.prepareShader = prepareShader_;
  return vulkan::Device::open(info_, options);
}

vulkan::Device& Workbench::device() {
  if (!device_) device_ = open({});
  return *device_;
}

render::Renderer& Workbench::renderer() {
  if (!renderer_) renderer_ = device::makeGpuRenderer(device());
  return *renderer_;
}

}  // namespace candela::conformance
