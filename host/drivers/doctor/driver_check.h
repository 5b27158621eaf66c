// Examines every driver on its own, and all of them together.
#pragma once
#include <string>
#include <vector>

#include "host/drivers/doctor/check.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::doctor {

struct DriverDiagnosis {
  Checks checks;
  std::vector<vulkan::DeviceInfo> devices;  ///< in the order of the loader; empty if listing them fails
  bool anyUsable = false;
};

/// A driver that fails is a problem if there is no usable device, else a warning. A driver whose devices are not in
/// this machine is `ok`. `hasLoader`: the Vulkan loader is installed, without which no driver can be examined.
DriverDiagnosis checkDrivers(bool hasLoader);

}  // namespace candela::doctor
