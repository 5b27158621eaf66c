// The examination of a machine: all checks and their conclusion.
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/base/errors.h"
#include "host/drivers/doctor/check.h"
#include "host/drivers/doctor/trial.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::doctor {

struct Diagnosis {
  Checks checks;                             ///< in the order of a report
  std::vector<vulkan::DeviceInfo> devices;   ///< as `candela devices` lists them
  std::optional<vulkan::DeviceInfo> device;  ///< the one that a render would use
  std::optional<Trial> trial;                ///< absent without a device

  /// `done`: a render will work; `differ`: its picture would be wrong; `noDevice`: it would fail.
  ExitCode code() const;
  /// One sentence on whether a render will work.
  std::string verdict() const;
};

/// Examines the machine for renders on the device for `selector` (see vulkan::selectDevice). Drivers run in child
/// processes, which may crash or hang. Call it while this process has one thread.
Diagnosis diagnose(const std::string& selector);

/// One line for each check, one for each remedy, and the verdict.
std::string toText(const Diagnosis& diagnosis);
nlohmann::ordered_json toJson(const Diagnosis& diagnosis);

}  // namespace candela::doctor
