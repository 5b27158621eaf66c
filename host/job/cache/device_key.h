// Identifies the device, driver and kernels for which a file of the cache is valid.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "host/trace/vulkan/device_info.h"

namespace candela::cache {

/// Two keys are equal if compiled pipelines and measured speeds of one are valid for the other.
struct DeviceKey {
  std::string device;
  std::string driver;
  std::string driverVersion;
  std::string pipelineCacheUuid;
  std::string kernels;  ///< SHA-256 of the code of all kernels, as hexadecimal digits

  bool operator==(const DeviceKey&) const = default;
};

/// Returns the key of a device with the kernels of this program.
DeviceKey keyOf(const vulkan::DeviceInfo& info);

/// Returns the members of the key.
nlohmann::ordered_json toJson(const DeviceKey& key);

/// Returns the key as one line of JSON. Equal texts mean equal keys.
std::string toText(const DeviceKey& key);

/// Returns "KIND-HASH.EXTENSION", with a hash of the key.
std::string fileNameOf(std::string_view kind, const DeviceKey& key, std::string_view extension);

}  // namespace candela::cache
