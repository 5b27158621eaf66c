// The compute-shader tracer.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host/render/replay.h"

namespace candela::vulkan {
class Device;
}

namespace candela::device {

struct GpuRendererOptions {
  /// Loop iterations that the device grants an invocation; absent: measured. Only tests state a limit of their own.
  std::optional<std::uint32_t> loopLimit;
};

/// The compute-shader tracer on the device that `selector` names (see selectDevice).
/// Throws NoDeviceError.
std::unique_ptr<render::ReplayingRenderer> makeGpuRenderer(const std::string& selector,
                                                           const GpuRendererOptions& options = {});
/// The compute-shader tracer on a device that is open already.
std::unique_ptr<render::ReplayingRenderer> makeGpuRenderer(vulkan::Device device,
                                                           const GpuRendererOptions& options = {});

}  // namespace candela::device
