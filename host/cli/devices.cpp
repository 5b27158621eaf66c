// `candela devices`: lists the Vulkan devices.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/commands.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/tuned.h"
#include "host/core/report_head.h"
#include "host/vulkan/device_info.h"

namespace candela::cli {
namespace {

constexpr double kMiB = 1024.0 * 1024;

using Kept = std::optional<KeptTuning>;

nlohmann::ordered_json toJson(const Kept& kept) {
  if (!kept) return nullptr;
  return {{"date", kept->tuning.date}, {"choice", tune::nameOf(kept->tuning.candidate)}, {"file", kept->file.string()}};
}

nlohmann::ordered_json toJson(const vulkan::DeviceInfo& device, const Kept& kept) {
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
          {"subgroupSize", device.subgroupSize},
          {"tuned", toJson(kept)}};
}

std::string toText(const vulkan::DeviceInfo& device, const Kept& kept) {
  std::string out = fmt::format("{:>3}  {} ({})\n", device.index, device.name, device.type);
  out += fmt::format("     driver {}, Vulkan {}\n", device.driver, device.apiVersion);
  out += fmt::format("     memory {:.0f} MiB, storage buffers to {:.0f} MiB, texel buffers to {} texels\n",
                     static_cast<double>(device.memoryBytes) / kMiB,
                     static_cast<double>(device.maxStorageBufferRange) / kMiB, device.maxTexelBufferElements);
  out += fmt::format("     workgroups to {} invocations ({}x{}x{}), subgroups of {}\n", device.maxWorkgroupInvocations,
                     device.maxWorkgroupSize[0], device.maxWorkgroupSize[1], device.maxWorkgroupSize[2],
                     device.subgroupSize);
  if (kept) out += fmt::format("     tuned {}: {}\n", kept->tuning.date, tune::nameOf(kept->tuning.candidate));
  if (!device.usable) out += fmt::format("     NOT USABLE: {}\n", device.whyNot);
  return out;
}

}  // namespace

ExitCode runDevices(const Arguments& arguments, const Log& log) {
  requireWritableReport(arguments.json);
  const std::vector<vulkan::DeviceInfo> devices = vulkan::listDevices();
  if (devices.empty()) vulkan::selectDevice("");  // throws NoDeviceError, which says what to install
  nlohmann::ordered_json json = reportHead("candela-devices/1");
  json["devices"] = nlohmann::ordered_json::array();
  std::string text;
  for (const vulkan::DeviceInfo& device : devices) {
    const Kept kept = keptTuning(device, log);
    text += toText(device, kept);
    json["devices"].push_back(toJson(device, kept));
  }
  text += "cpu  the reference tracer, in double precision (--device cpu)\n";
  if (arguments.wantsText()) std::cout << text << std::flush;
  writeJson(arguments.json, json);
  return ExitCode::done;
}

}  // namespace candela::cli
