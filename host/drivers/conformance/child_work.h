// A child process of a run runs cases one after the other, and sends a value before and after each.
#pragma once
#include <vector>

#include "host/drivers/child_process.h"
#include "host/drivers/conformance/case.h"
#include "host/drivers/conformance/status.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::conformance {

/// A message of a child. The one before a case has no status.
struct ChildNote {
  std::optional<Status> status;
  std::string text;
  double seconds = 0;
};

nlohmann::json toJson(const ChildNote& note);
ChildNote noteFrom(const nlohmann::json& json);

/// Runs the cases, and ends early after a device was lost, because it cannot run any more.
void runInThisProcess(const std::vector<const Case*>& cases, const vulkan::DeviceInfo& device,
                      const process::ChildProcess::Send& send);

}  // namespace candela::conformance
