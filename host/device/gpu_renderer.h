// The compute-shader tracer.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host/render/renderer.h"

namespace candela::vulkan {
class Device;
}

namespace candela::device {

struct GpuRendererOptions {
  /// Loop iterations that the device grants an invocation; absent: measured. Only tests state a limit of their own.
  std::optional<std::uint32_t> loopLimit;
  /// Maximum size of a buffer of path states or film. The default is what every device allocates in one piece; tests
  /// divide small images into bands with less.
  std::uint64_t maxBandBytes = std::uint64_t{1} << 30;
};

/// The compute-shader tracer on the device that `selector` names (see selectDevice).
/// Throws NoDeviceError.
std::unique_ptr<render::Renderer> makeGpuRenderer(const std::string& selector, const GpuRendererOptions& options = {});
/// The compute-shader tracer on a device that is open already.
std::unique_ptr<render::Renderer> makeGpuRenderer(vulkan::Device device, const GpuRendererOptions& options = {});

}  // namespace candela::device
