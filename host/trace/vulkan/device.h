// An open Vulkan device with its compute queue; this header uses no Vulkan type.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/trace/vulkan/command_recorder.h"
#include "host/trace/vulkan/device_info.h"
#include "host/trace/vulkan/memory_tally.h"
#include "host/trace/vulkan/shader_code.h"

namespace candela::vulkan {

struct Recording;

struct DeviceOptions {
  /// Size of the staging buffer, through which memory that the host cannot map is written and read in chunks.
  std::size_t stagingBytes = std::size_t{8} << 20;
  /// False: use the staging buffer even if device memory can be mapped, as on a discrete GPU.
  bool mapDeviceMemory = true;
  /// Maximum duration of a run in seconds; 0: unlimited. Absent: see HangLimit for hardware; unlimited for
  /// software devices, which are slow on a loaded machine.
  std::optional<double> hangTimeout{};
  /// True: enables robustBufferAccess, with which shaders cannot access memory beyond their buffers.
  bool robustBufferAccess = false;
  /// Number of invocations in a subgroup of every pipeline, from DeviceInfo::minSubgroupSize to maxSubgroupSize and a
  /// power of two; 0: as the driver chooses.
  std::uint32_t subgroupSize = 0;
  /// Receives all work that the device is given after it was opened; null: nothing is recorded.
  std::shared_ptr<Recording> recording{};
  /// Converts the code of every pipeline, unless PipelineOptions::isFinal; empty: reducedSpirv() converts it.
  PrepareShader prepareShader{};
  /// True: the device creates pipelines and runs nothing, so that it needs neither memory nor commands, and
  /// reportPipeline() returns what its driver reports.
  bool compilesOnly = false;
  /// Instance extensions of a window system. If there are any, the device can present to its windows, provided that it
  /// has VK_KHR_swapchain: see Device::canPresent().
  std::vector<std::string> windowExtensions{};
};

/// A device, its compute queue and the state that buffers and pipelines need. Vulkan 1.2 core, no optional feature. It
/// is a cheap handle: buffers and pipelines share ownership, so that the order of their destruction is irrelevant. Runs
/// and transfers belong to one thread at a time. Objects may be created and destroyed by several threads, and another
/// thread may present frames (host/app/window). Every member may throw DeviceLostError, OutOfMemoryError, or
/// InternalError with the name of the Vulkan result.
///
/// After a run that failed, every further run throws DeviceLostError. Objects of the device may be destroyed at any
/// time: those that the device may still be using are kept until the end of the process (see unfinished_work.h).
///
/// Environment: CANDELA_VALIDATION=1 enables the Khronos validation layer (see validation.h).
class Device {
 public:
  /// Opens the device for a `selector` of selectDevice(). Throws NoDeviceError.
  static Device open(const std::string& selector = "", const DeviceOptions& options = {});
  /// Opens a device returned by listDevices(). Throws NoDeviceError if it is not usable or no longer present.
  static Device open(const DeviceInfo& info, const DeviceOptions& options = {});

  const DeviceInfo& info() const;
  /// Returns the bytes of the device's Buffer objects.
  MemoryUse memoryUse() const;

  /// Calls `record`, submits the recorded commands, waits for their end, and returns the seconds from submission to end
  /// (steady clock). All writes of the commands are then visible to the host and to later runs. Calls must not be
  /// nested. Throws DeviceHungError if the commands do not end in time, for which the first run of a pipeline has more
  /// time than others.
  double run(const std::function<void(CommandRecorder&)>& record);

  /// Returns whether DeviceOptions::windowExtensions were given, and the device and its queue can draw and present.
  bool canPresent() const;

  /// Returns whether a run failed, so that the device cannot be used any more.
  bool hasFailed() const;

  /// Adds the pipelines in `data`, which pipelineData() returned for the same device and driver, to the pipeline cache
  /// of this device. Drivers trust such data, so it must not come from an unchecked file. Data of another device is
  /// ignored.
  void loadPipelines(std::span<const std::byte> data);
  /// Returns the content of the pipeline cache: all pipelines that were loaded or created so far, if the driver returns
  /// them.
  std::vector<std::byte> pipelineData() const;

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  explicit Device(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
