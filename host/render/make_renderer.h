// Makes the two tracers.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host/render/replay.h"

namespace candela::vulkan {
class Device;
}

namespace candela {

struct GpuRendererOptions {
  /// Loop turns that the device grants an invocation; absent: measured. Only tests state what is not so.
  std::optional<std::uint32_t> loopLimit;
};

/// The compute-shader tracer on the device that `selector` names (see selectDevice).
/// Throws NoDeviceError.
std::unique_ptr<ReplayingRenderer> makeGpuRenderer(const std::string& selector, const GpuRendererOptions& options = {});
/// The same on a device that is open already.
std::unique_ptr<ReplayingRenderer> makeGpuRenderer(vulkan::Device device, const GpuRendererOptions& options = {});
/// The independent double-precision tracer.
std::unique_ptr<ReplayingRenderer> makeReferenceRenderer();

}  // namespace candela
