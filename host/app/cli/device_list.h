// The Vulkan devices of this machine with their stored tuning, as `candela devices` and Python list them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/app/cli/tuned.h"
#include "host/base/log.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::cli {

struct ListedDevice {
  vulkan::DeviceInfo info;
  bool isDefault = false;            ///< used if no device is selected
  std::optional<KeptTuning> tuning;  ///< stored by `candela tune`
};

/// Lists all devices, or with a selector (see vulkan::selectDevice) one. Throws NoDeviceError if there is none.
std::vector<ListedDevice> listedDevices(const std::string& selector, const Log& log);

/// Returns an object of the array `devices` of `candela devices --json`.
nlohmann::ordered_json toJson(const ListedDevice& device);

}  // namespace candela::cli
