// The order of the checks, and the verdict.
#include "host/drivers/doctor/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/setting_words.h"
#include "host/drivers/doctor/caches.h"
#include "host/drivers/doctor/check.h"
#include "host/drivers/doctor/driver_check.h"
#include "host/drivers/doctor/gpu_nodes.h"
#include "host/drivers/doctor/known_faults.h"
#include "host/drivers/doctor/resources.h"
#include "host/trace/vulkan/device_choice.h"
#include "host/trace/vulkan/loader_info.h"
#include "host/trace/vulkan/validation.h"

namespace candela::doctor {
namespace {

Check checkValidation(bool installed) {
  const bool requested = vulkan::validationRequested();
  Check check{"validation layer", Status::ok, "", ""};
  if (installed) {
    check.text = requested ? "installed, and on (CANDELA_VALIDATION)" : "installed; CANDELA_VALIDATION=1 turns it on";
  } else if (requested) {
    check = {"validation layer", Status::problem, "CANDELA_VALIDATION requests it, but it is not installed",
             "apt-get install vulkan-validationlayers, or unset CANDELA_VALIDATION"};
  } else {
    check.text = "not installed; only tests of Candela need it";
  }
  return check;
}

/// The first check is that of the loader, and it is `ok` if the loader can be opened.
Checks checkLoader() {
  const std::optional<vulkan::LoaderInfo> loader = vulkan::findLoader();
  if (!loader) {
    return {{"Vulkan loader", Status::problem, "libvulkan.so.1 cannot be opened",
             "apt-get install libvulkan1 mesa-vulkan-drivers"}};
  }
  return {{"Vulkan loader", Status::ok, "version " + loader->version, ""}, checkValidation(loader->hasValidation)};
}

void append(Checks& checks, Checks more) {
  for (Check& check : more) checks.push_back(std::move(check));
}

bool hasHardware(const std::vector<vulkan::DeviceInfo>& devices) {
  return std::ranges::any_of(devices, [](const vulkan::DeviceInfo& device) { return !device.isSoftware(); });
}

void chooseFor(const std::string& selector, Diagnosis& diagnosis) {
  try {
    diagnosis.device = vulkan::chooseDevice(diagnosis.devices, selector);
  } catch (const NoDeviceError& error) {
    if (diagnosis.devices.empty()) return;  // a problem of the drivers, which is in the list already
    const std::string message = error.what();
    const std::string line = message.substr(0, message.find('\n'));
    diagnosis.checks.push_back({"chosen device", Status::problem, line.substr(0, line.rfind("; available devices")),
                                "choose one of the devices above"});
  }
}

// Empty if it was removed.
std::filesystem::path workingFolder() {
  std::error_code ignored;
  return std::filesystem::current_path(ignored);
}

}  // namespace

Diagnosis diagnose(const std::string& selector) {
  Diagnosis diagnosis;
  diagnosis.checks = checkLoader();
  DriverDiagnosis drivers = checkDrivers(diagnosis.checks.front().status == Status::ok);
  append(diagnosis.checks, std::move(drivers.checks));
  diagnosis.devices = std::move(drivers.devices);
  append(diagnosis.checks, checkGpuNodes("/dev", hasHardware(diagnosis.devices)));
  chooseFor(selector, diagnosis);
  if (diagnosis.device) append(diagnosis.checks, checkKnownFaults(*diagnosis.device));
  append(diagnosis.checks, checkCaches(diagnosis.device));
  append(diagnosis.checks, checkResources(workingFolder()));
  if (!diagnosis.device) return diagnosis;
  diagnosis.trial = tryRender(std::to_string(diagnosis.device->index));
  diagnosis.checks.push_back(diagnosis.trial->check);
  return diagnosis;
}

ExitCode Diagnosis::code() const {
  if (!trial || trial->outcome == TrialOutcome::fails) return ExitCode::noDevice;
  if (trial->outcome == TrialOutcome::undecided) return ExitCode::undecided;
  return trial->outcome == TrialOutcome::wrong ? ExitCode::differ : ExitCode::done;
}

std::string Diagnosis::verdict() const {
  switch (code()) {
    case ExitCode::done:
      return fmt::format("A render will work, on {}{}.", device->name,
                         device->isSoftware() ? ", in software: the picture is right, but a GPU is faster" : "");
    case ExitCode::undecided:
      return fmt::format("A render will work, on {}, but whether its picture is right is not decided.", device->name);
    case ExitCode::differ:
      return fmt::format("The pictures of {} are WRONG. `{}` renders correct ones without Vulkan.", device->name,
                         settingWords("device", "cpu"));
    default:
      return fmt::format(
          "A render will not work on a Vulkan device; see the problems above. `{}` renders without Vulkan.",
          settingWords("device", "cpu"));
  }
}

}  // namespace candela::doctor
