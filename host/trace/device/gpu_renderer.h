// Creates the compute-shader tracer.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host/trace/device/code_form.h"
#include "host/trace/render/renderer.h"

namespace candela::vulkan {
class Device;
}

namespace candela::device {

struct GpuRendererOptions {
  /// Loop iterations that the device executes in an invocation; absent: measured. Only tests set it.
  std::optional<std::uint32_t> loopLimit{};
  /// Absent: that of the device. Only tests set it.
  std::optional<CodeForm> form{};
  /// Maximum size of a buffer of path states or film. Every device can allocate the default in one piece; tests set
  /// less in order to divide small images into bands.
  std::uint64_t maxBandBytes = std::uint64_t{1} << 30;
};

/// The compute-shader tracer on the device that `selector` names (see selectDevice).
/// Throws NoDeviceError.
std::unique_ptr<render::Renderer> makeGpuRenderer(const std::string& selector, const GpuRendererOptions& options = {});
/// The compute-shader tracer on a device that is already open.
std::unique_ptr<render::Renderer> makeGpuRenderer(vulkan::Device device, const GpuRendererOptions& options = {});

}  // namespace candela::device
