// The table of known faults.
#include "host/drivers/doctor/known_faults.h"

#include <fmt/format.h>

#include <array>

#include "host/base/lower_case.h"

namespace candela::doctor {
namespace {

constexpr std::array kFaults{
    KnownFault{"llvmpipe", "stops the loops of an invocation after 65,535 iterations in total",
               "a scene that needs more in one dispatch fails with an error and never shows a wrong picture",
               "docs/driver-workarounds.md#4-a-word-beside-each-loop-condition"},
    KnownFault{"llvmpipe", "recompiles kernels with uniform loop bounds at every dispatch and never frees them",
               "no kernel of Candela has such loops", "docs/driver-workarounds.md#5-no-loop-bound-that-is-uniform"},
    KnownFault{"swiftshader", "compiles code that a specialisation constant disables",
               "Candela removes that code first; kernels take a second or two to compile",
               "docs/driver-workarounds.md#10-no-dead-code-in-kernels"},
    KnownFault{"swiftshader", "binds at most 65,536 texels", "larger scenes are read through storage buffers",
               "docs/driver-workarounds.md#9-texel-loads-or-storage-loads"},
};

}  // namespace

std::span<const KnownFault> knownFaults() { return kFaults; }

Checks checkKnownFaults(const vulkan::DeviceInfo& device) {
  const std::string names = lowerCase(device.name + " " + device.driver);
  Checks checks;
  for (const KnownFault& fault : kFaults) {
    if (names.find(fault.driver) == std::string::npos) continue;
    checks.push_back({"known fault", Status::ok,
                      fmt::format("{} {}; {} ({})", fault.driver, fault.fault, fault.effect, fault.evidence), ""});
  }
  return checks;
}

}  // namespace candela::doctor
