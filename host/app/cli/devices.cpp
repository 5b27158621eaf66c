// `candela devices`: lists the Vulkan devices.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/device_list.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/requirements.h"
#include "host/app/cli/text_output.h"
#include "host/base/report_head.h"

namespace candela::cli {
namespace {

constexpr double kMiB = 1024.0 * 1024;

std::string toText(const ListedDevice& listed) {
  const vulkan::DeviceInfo& device = listed.info;
  const auto& kept = listed.tuning;
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

ExitCode run(const DevicesArguments& arguments, const Log& log) {
  requireWritableReport(arguments.json);
  requireVulkanDevice(arguments, "the reference tracer is not a Vulkan device");
  nlohmann::ordered_json json = reportHead("candela-devices/1");
  json["devices"] = nlohmann::ordered_json::array();
  std::string text;
  for (const ListedDevice& device : listedDevices(arguments.device, log)) {
    text += toText(device);
    json["devices"].push_back(toJson(device));
  }
  if (arguments.device.empty()) text += "cpu  the reference tracer, in double precision (--device cpu)\n";
  if (wantsText(arguments, {arguments.json})) std::cout << text << std::flush;
  writeJson(arguments.json, json);
  return ExitCode::done;
}

}  // namespace candela::cli
