// Selects one of several devices.
#include "host/trace/vulkan/device_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "host/base/environment.h"
#include "host/base/errors.h"
#include "host/base/lower_case.h"
#include "host/base/setting_words.h"

namespace candela::vulkan {
namespace {

std::string howToGoOn() {
  return fmt::format(
      "candela doctor reports the cause; {} renders without Vulkan; a driver that runs on any machine is installed on "
      "Debian by: apt-get install mesa-vulkan-drivers",
      settingWords("device", "cpu"));
}

// Environment variables by which the Vulkan loader uses the drivers of these files alone. The first one that is set
// hides the second one.
constexpr std::array kDriverVariables{"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};

// Returns the environment variable that selects the drivers, in parentheses; empty if none does.
std::string chosenDrivers() {
  for (const char* const name : kDriverVariables) {
    const std::string value = environmentVariable(name);
    if (!value.empty()) return fmt::format(" (the environment variable {} allows only the driver {})", name, value);
  }
  return "";
}

/// Returns the selector as an index into the list, if it is one. "3060" is not an index if there are two devices, but
/// may be part of a name.
std::optional<std::size_t> asIndex(const std::string& selector, std::size_t count) {
  std::size_t index = 0;
  const char* end = selector.data() + selector.size();
  const auto [rest, error] = std::from_chars(selector.data(), end, index);
  if (error != std::errc{} || rest != end || index >= count) return std::nullopt;
  return index;
}

/// Returns the position in the order of preference; lower is better.
std::size_t rank(const DeviceInfo& device) {
  static const std::array<std::string, 4> kOrder{"discrete GPU", "integrated GPU", "virtual GPU", "CPU"};
  return static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), device.type) - kOrder.begin());
}

/// Returns the first usable device that matches the selector, else the first that matches, else null.
const DeviceInfo* namedDevice(std::span<const DeviceInfo> devices, const std::string& selector) {
  if (const auto index = asIndex(selector, devices.size())) return &devices[*index];
  const DeviceInfo* named = nullptr;
  for (const DeviceInfo& device : devices) {
    if (lowerCase(device.name).find(lowerCase(selector)) == std::string::npos) continue;
    if (named == nullptr || (device.usable && !named->usable)) named = &device;
  }
  return named;
}

}  // namespace

const DeviceInfo* bestDevice(std::span<const DeviceInfo> devices) {
  const DeviceInfo* best = nullptr;
  for (const DeviceInfo& device : devices) {
    if (device.usable && (best == nullptr || rank(device) < rank(*best))) best = &device;
  }
  return best;
}

std::string describeDevices(std::span<const DeviceInfo> devices) {
  std::string text;
  for (const DeviceInfo& device : devices) {
    text += fmt::format("\n  {}: {} ({})", device.index, device.name, device.type);
    if (!device.usable) text += fmt::format(", not usable: {}", device.whyNot);
  }
  return text;
}

void allowCompilers(std::span<DeviceInfo> devices) {
  for (DeviceInfo& device : devices) device.usable = device.compiles;
}

const DeviceInfo& chooseDevice(std::span<const DeviceInfo> devices, const std::string& selector) {
  if (devices.empty()) throw NoDeviceError(fmt::format("no Vulkan device found{}; {}", chosenDrivers(), howToGoOn()));
  const DeviceInfo* device = selector.empty() ? bestDevice(devices) : namedDevice(devices, selector);
  if (device == nullptr && selector.empty()) {
    throw NoDeviceError(fmt::format("no usable Vulkan device{}; {}; available devices:{}", chosenDrivers(), howToGoOn(),
                                    describeDevices(devices)));
  }
  if (device == nullptr) {
    throw NoDeviceError(
        fmt::format("no Vulkan device \"{}\"; available devices:{}\n  cpu: the reference tracer, which needs no device",
                    selector, describeDevices(devices)));
  }
  if (!device->usable) {
    throw NoDeviceError(fmt::format("Vulkan device {} ({}) is not usable: {}; available devices:{}", device->index,
                                    device->name, device->whyNot, describeDevices(devices)));
  }
  return *device;
}

}  // namespace candela::vulkan
