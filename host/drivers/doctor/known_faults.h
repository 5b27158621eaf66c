// Known faults of drivers, with the evidence.
#pragma once
#include <span>
#include <string_view>

#include "host/drivers/doctor/check.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::doctor {

struct KnownFault {
  std::string_view driver;    ///< part of the name of the device or of the driver, in lower case
  std::string_view fault;     ///< predicate of a sentence about the driver
  std::string_view effect;    ///< sentence on the consequences for renders
  std::string_view evidence;  ///< page and heading
};

std::span<const KnownFault> knownFaults();

/// Returns one line for each fault of the device. None needs a remedy, since Candela avoids or detects it.
Checks checkKnownFaults(const vulkan::DeviceInfo& device);

}  // namespace candela::doctor
