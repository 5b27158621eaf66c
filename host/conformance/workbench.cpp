// Opens the device when it is first needed.
#include "host/conformance/workbench.h"

#include "host/device/gpu_renderer.h"
#include "host/reference/reference_renderer.h"

namespace candela::conformance {

Workbench::Workbench(vulkan::DeviceInfo info)
    : info_(std::move(info)), reference_(reference::makeReferenceRenderer()) {}

vulkan::Device& Workbench::device() {
  if (!device_) device_ = vulkan::Device::open(info_);
  return *device_;
}

render::Renderer& Workbench::renderer() {
  if (!renderer_) renderer_ = device::makeGpuRenderer(device());
  return *renderer_;
}

}  // namespace candela::conformance
