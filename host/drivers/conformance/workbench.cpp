// Opens the device when it is first needed.
#include "host/drivers/conformance/workbench.h"

#include "host/trace/device/gpu_renderer.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::conformance {

Workbench::Workbench(vulkan::DeviceInfo info, vulkan::DeviceOptions common)
    : info_(std::move(info)), common_(std::move(common)), reference_(reference::makeReferenceRenderer()) {}

vulkan::Device Workbench::open(vulkan::DeviceOptions options) const {
  options.recording = common_.recording;
  options.prepareShader = common_.prepareShader;
  options.compilesOnly = common_.compilesOnly;
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
