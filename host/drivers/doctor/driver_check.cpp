// Examines every driver on its own, and all of them together.
#include "host/drivers/doctor/driver_check.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/environment.h"
#include "host/drivers/doctor/devices.h"
#include "host/drivers/doctor/driver_files.h"

namespace candela::doctor {
namespace {

constexpr const char* kInstall = "apt-get install mesa-vulkan-drivers";

struct DriverResult {
  DriverManifest manifest;
  ListedDevices listed;

  bool broken() const { return !manifest.problem.empty() || !listed.failure.empty(); }
  // 64-bit and 32-bit drivers register in the same folder, and the loader skips those of the other kind.
  bool isOfOtherWordSize() const { return listed.failure.find("wrong ELF class") != std::string::npos; }
  bool works() const { return std::ranges::any_of(listed.devices, &vulkan::DeviceInfo::usable); }
};

DriverResult examine(const DriverManifest& manifest, bool hasLoader) {
  if (!manifest.problem.empty() || !hasLoader) return {manifest, {}};
  return {manifest, listDevicesOf(manifest.file.string(), manifest.library)};
}

std::string namesOf(const std::vector<vulkan::DeviceInfo>& devices) {
  std::string names;
  for (const vulkan::DeviceInfo& device : devices) names += (names.empty() ? "" : ", ") + device.name;
  return names;
}

std::string workingDrivers(const std::vector<DriverResult>& results) {
  std::string files;
  for (const DriverResult& result : results) {
    if (result.works()) files += (files.empty() ? "" : ":") + result.manifest.file.string();
  }
  return files;
}

// `others` are the drivers to use instead.
std::string remedyFor(const DriverResult& result, const std::string& variable, const std::string& others) {
  if (!variable.empty() && !result.manifest.problem.empty()) return fmt::format("unset {}, or correct it", variable);
  const std::string reinstall = fmt::format("reinstall the package that `dpkg -S {}` names, or delete this file",
                                            result.manifest.file.string());
  if (others.empty()) return fmt::format("{}; for a driver that runs on any machine: {}", reinstall, kInstall);
  return fmt::format("{}; to leave this driver out: export VK_ICD_FILENAMES={}", reinstall, others);
}

Check checkOf(const DriverResult& result, const DriverFiles& files, const std::string& others, bool anyUsable,
              bool hasLoader) {
  Check check{fmt::format("driver {}", result.manifest.file.filename().string()), Status::ok, "", ""};
  if (result.isOfOtherWordSize()) {
    check.text = "for programs of another word size; not used";
  } else if (!result.broken() && !hasLoader) {
    check.text = "registered; it cannot be examined without the Vulkan loader";
  } else if (!result.broken()) {
    check.text = result.listed.devices.empty() ? "works, but none of its devices is in this machine"
                                               : namesOf(result.listed.devices);
  } else {
    check.status = anyUsable ? Status::warning : Status::problem;
    check.text = result.manifest.problem.empty()
                     ? fmt::format("{} {}", result.manifest.library, result.listed.failure)
                     : fmt::format("{} {}", result.manifest.file.string(), result.manifest.problem);
    check.remedy = remedyFor(result, files.variable, others);
  }
  return check;
}

Check noDriver(const DriverFiles& files) {
  if (!files.variable.empty()) {
    return {"drivers", Status::problem, files.variable + " names no driver", "unset " + files.variable};
  }
  std::string folders;
  for (const std::filesystem::path& folder : files.folders) folders += (folders.empty() ? "" : ", ") + folder.string();
  return {"drivers", Status::problem, "no driver is registered in " + folders, kInstall};
}

// A driver cannot be found, even if it is installed, while a variable names others.
std::string installOrUnset(const std::string& variable) {
  return variable.empty() ? kInstall : fmt::format("unset {}; if that does not help: {}", variable, kInstall);
}

Check noLoader() {
  return {"devices", Status::problem, "none can be found without the Vulkan loader", "apt-get install libvulkan1"};
}

std::string hidingText(const std::string& variable) {
  if (variable.empty()) return "";
  const std::string value = environmentVariable(variable.c_str());
  return value.empty() ? fmt::format("; {} is set, but names no driver", variable)
                       : fmt::format("; {}={} may hide drivers", variable, value);
}

// Examines the devices that the loader finds with all drivers, as a render does.
Check summary(const ListedDevices& all, const DriverFiles& files, const std::string& working) {
  const std::string& variable = files.hidingVariable.empty() ? files.variable : files.hidingVariable;
  if (!all.failure.empty()) {
    return {"devices", Status::problem, fmt::format("listing the devices of all drivers {}", all.failure),
            working.empty() ? installOrUnset(variable) : "export VK_ICD_FILENAMES=" + working};
  }
  if (std::ranges::any_of(all.devices, &vulkan::DeviceInfo::usable)) {
    return {"devices", Status::ok, fmt::format("{} found", all.devices.size()), ""};
  }
  std::string text = all.devices.empty() ? "none found" : "none of them is usable";
  text += hidingText(files.hidingVariable);
  return {"devices", Status::problem, text, installOrUnset(variable)};
}

}  // namespace

DriverDiagnosis checkDrivers(bool hasLoader) {
  const DriverFiles files = findDriverFiles();
  std::vector<DriverResult> results;
  for (const DriverManifest& manifest : files.manifests) results.push_back(examine(manifest, hasLoader));
  const std::string working = workingDrivers(results);
  const ListedDevices all = listAllDevices();
  DriverDiagnosis diagnosis{{}, all.devices, std::ranges::any_of(all.devices, &vulkan::DeviceInfo::usable)};
  for (const DriverResult& result : results) {
    diagnosis.checks.push_back(checkOf(result, files, working, diagnosis.anyUsable, hasLoader));
  }
  if (results.empty()) diagnosis.checks.push_back(noDriver(files));
  diagnosis.checks.push_back(hasLoader ? summary(all, files, working) : noLoader());
  for (Check& check : checkDevices(all.devices)) diagnosis.checks.push_back(std::move(check));
  return diagnosis;
}

}  // namespace candela::doctor
