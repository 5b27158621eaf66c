// `candela devices`: what there is to render on.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/commands.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/vulkan/device_info.h"

namespace candela::cli {
namespace {

constexpr double kMiB = 1024.0 * 1024;

nlohmann::ordered_json toJson(const DeviceInfo& device) {
  return {{"index", device.index},
          {"name", device.name},
          {"type", device.type},
          {"driver", device.driver},
          {"apiVersion", device.apiVersion},
          {"usable", device.usable},
          {"whyNot", device.whyNot},
          {"memoryBytes", device.memoryBytes},
          {"maxStorageBufferRange", device.maxStorageBufferRange},
          {"maxTexelBufferElements", device.maxTexelBufferElements},
          {"maxWorkgroupInvocations", device.maxWorkgroupInvocations},
          {"maxWorkgroupSize", device.maxWorkgroupSize},
          {"subgroupSize", device.subgroupSize}};
}

std::string toText(const DeviceInfo& device) {
  std::string out = fmt::format("{:>3}  {} ({})\n", device.index, device.name, device.type);
  out += fmt::format("     driver {}, Vulkan {}\n", device.driver, device.apiVersion);
  out += fmt::format("     memory {:.0f} MiB, storage buffers to {:.0f} MiB, texel buffers to {} texels\n",
                     static_cast<double>(device.memoryBytes) / kMiB,
                     static_cast<double>(device.maxStorageBufferRange) / kMiB, device.maxTexelBufferElements);
  out += fmt::format("     workgroups to {} invocations ({}x{}x{}), subgroups of {}\n", device.maxWorkgroupInvocations,
                     device.maxWorkgroupSize[0], device.maxWorkgroupSize[1], device.maxWorkgroupSize[2],
                     device.subgroupSize);
  if (!device.usable) out += fmt::format("     NOT USABLE: {}\n", device.whyNot);
  return out;
}

}  // namespace

ExitCode runDevices(const Arguments& arguments, const Log&) {
  requireWritableReport(arguments.json);
  const std::vector<DeviceInfo> devices = listDevices();
  if (devices.empty()) selectDevice("");  // throws, and says what to install
  if (arguments.wantsText()) {
    for (const DeviceInfo& device : devices) std::cout << toText(device);
    std::cout << "cpu  the reference tracer, in double precision (--device cpu)\n" << std::flush;
  }
  nlohmann::ordered_json json;
  json["devices"] = nlohmann::ordered_json::array();
  for (const DeviceInfo& device : devices) json["devices"].push_back(toJson(device));
  writeJson(arguments.json, json);
  return ExitCode::done;
}

}  // namespace candela::cli
