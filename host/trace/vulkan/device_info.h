// Information about Vulkan devices; this header uses no Vulkan type.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace candela::vulkan {

struct DeviceInfo {
  std::uint32_t index = 0;
  std::string name;
  std::string type;                 ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
  std::string driverName;           ///< e.g. "radv"; only for Vulkan 1.2
  std::string driver;               ///< name and version text, e.g. "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
  std::uint32_t driverVersion = 0;  ///< in the driver's own encoding
  std::string driverUuid;           ///< 32 hexadecimal digits; only for Vulkan 1.2
  std::string pipelineCacheUuid;    ///< 32 hexadecimal digits; they change with the driver and the device
  std::string apiVersion;           ///< "1.3.230"
  bool usable = false;
  std::string whyNot;             ///< if not usable: the reason
  bool compiles = false;          ///< it has what pipelines need; a device that is usable compiles, too
  std::uint64_t memoryBytes = 0;  ///< size of the device-local heaps
  std::uint64_t maxStorageBufferRange = 0;
  std::uint64_t maxTexelBufferElements = 0;
  std::uint32_t maxWorkgroupInvocations = 0;
  std::uint32_t maxWorkgroupSize[3]{};
  std::uint32_t subgroupSize = 0;
  std::uint32_t minSubgroupSize = 0;  ///< that a compute pipeline may require; 0: it cannot require any
  std::uint32_t maxSubgroupSize = 0;

  /// Returns whether the driver renders on the CPU, so that the device's memory is the host's.
  bool isSoftware() const { return type == "CPU"; }
};

/// Returns every device of every Vulkan driver, in the order of the loader. Empty if there is none.
std::vector<DeviceInfo> listDevices();
/// Returns the device for a `selector`: an index, or a part of a device's name in any case. Empty: the first discrete
/// GPU, else integrated, else virtual, else CPU. Throws NoDeviceError, which lists the devices or, if there are none,
/// names the package to install.
DeviceInfo selectDevice(const std::string& selector);

}  // namespace candela::vulkan
