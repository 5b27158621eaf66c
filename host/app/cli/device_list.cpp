// Lists devices.
#include "host/app/cli/device_list.h"

#include "host/trace/vulkan/device_choice.h"

namespace candela::cli {
namespace {

nlohmann::ordered_json toJson(const std::optional<KeptTuning>& kept) {
  if (!kept) return nullptr;
  return {{"date", kept->tuning.date}, {"choice", tune::nameOf(kept->tuning.candidate)}, {"file", kept->file.string()}};
}

}  // namespace

std::vector<ListedDevice> listedDevices(const std::string& selector, const Log& log) {
  const std::vector<vulkan::DeviceInfo> all = vulkan::listDevices();
  if (all.empty()) vulkan::chooseDevice(all, "");  // throws NoDeviceError, which says what to install
  const vulkan::DeviceInfo* const best = vulkan::bestDevice(all);
  const vulkan::DeviceInfo* const chosen = selector.empty() ? nullptr : &vulkan::chooseDevice(all, selector);
  std::vector<ListedDevice> listed;
  for (const vulkan::DeviceInfo& device : all) {
    if (chosen == nullptr || chosen == &device) listed.push_back({device, &device == best, keptTuning(device, log)});
  }
  return listed;
}

nlohmann::ordered_json toJson(const ListedDevice& device) {
  const vulkan::DeviceInfo& info = device.info;
  return {{"index", info.index},
          {"name", info.name},
          {"type", info.type},
          {"driver", info.driver},
          {"apiVersion", info.apiVersion},
          {"usable", info.usable},
          {"whyNot", info.whyNot},
          {"compiles", info.compiles},
          {"default", device.isDefault},
          {"memoryBytes", info.memoryBytes},
          {"maxStorageBufferRange", info.maxStorageBufferRange},
          {"maxTexelBufferElements", info.maxTexelBufferElements},
          {"maxWorkgroupInvocations", info.maxWorkgroupInvocations},
          {"maxWorkgroupSize", info.maxWorkgroupSize},
          {"subgroupSize", info.subgroupSize},
          {"tuned", toJson(device.tuning)}};
}

}  // namespace candela::cli
