// An opened Vulkan device with its one compute queue, told without any Vulkan type.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "host/vulkan/command_recorder.h"
#include "host/vulkan/device_info.h"

namespace candela::vulkan {

/// Bytes of device memory that the buffers of one Device hold.
struct MemoryUse {
  std::uint64_t currentBytes = 0;
  std::uint64_t peakBytes = 0;
};

struct DeviceOptions {
  /// Size of the buffer through which memory that the host cannot map is read and written, chunk by chunk.
  std::size_t stagingBytes = std::size_t{8} << 20;
  /// False: go through the staging buffer even where device memory can be mapped, as on a discrete GPU.
  bool mapDeviceMemory = true;
};

/// A device, its compute queue and what buffers and pipelines need of it. Vulkan 1.2 core, no optional feature.
/// A cheap handle: buffers and pipelines share ownership, so the order in which they go does not matter. All that
/// belongs to one device is used by one thread at a time. Every member may throw DeviceLostError, OutOfMemoryError, or
/// InternalError with the name of the Vulkan result.
///
/// Environment: CANDELA_VALIDATION=1 turns the Khronos validation layer on (see validation.h).
class Device {
 public:
  /// `selector` as for selectDevice(). Throws NoDeviceError.
  static Device open(const std::string& selector = "", const DeviceOptions& options = {});
  /// `info` as listDevices() told it. Throws NoDeviceError if it is not usable or no longer there.
  static Device open(const DeviceInfo& info, const DeviceOptions& options = {});

  const DeviceInfo& info() const;
  MemoryUse memoryUse() const;

  /// Calls `record`, submits what it recorded, waits for the end, and returns the seconds from submission to end
  /// (steady clock). Everything that the commands wrote is then visible to the host and to later runs. Not to be
  /// nested.
  double run(const std::function<void(CommandRecorder&)>& record);

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  explicit Device(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
