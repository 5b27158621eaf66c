// What devices there are, told without any Vulkan type.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace candela::vulkan {

struct DeviceInfo {
  std::uint32_t index = 0;
  std::string name;
  std::string type;                 ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU", "other"
  std::string driver;               ///< name and version text, e.g. "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
  std::uint32_t driverVersion = 0;  ///< in the driver's own notation
  std::string pipelineCacheUuid;    ///< 32 hexadecimal digits; another one means another driver or device
  std::string apiVersion;           ///< "1.3.230"
  bool usable = false;
  std::string whyNot;             ///< if not usable: what is missing
  std::uint64_t memoryBytes = 0;  ///< of device-local heaps
  std::uint64_t maxStorageBufferRange = 0;
  std::uint64_t maxTexelBufferElements = 0;
  std::uint32_t maxWorkgroupInvocations = 0;
  std::uint32_t maxWorkgroupSize[3]{};
  std::uint32_t subgroupSize = 0;
};

/// Every device of every Vulkan driver found, in the loader's order. Empty if there is none.
std::vector<DeviceInfo> listDevices();
/// `selector`: an index, or a part of a device's name (any case); empty: the first discrete GPU, else integrated, else
/// virtual, else CPU. Throws NoDeviceError, which lists what there is and, if nothing, what to install.
DeviceInfo selectDevice(const std::string& selector);

}  // namespace candela::vulkan
