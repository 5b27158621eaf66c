// Lists Vulkan devices in a child process.
#include "host/drivers/doctor/devices.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "host/drivers/child_process.h"
#include "host/drivers/doctor/driver_files.h"

namespace candela::doctor {
namespace {

constexpr double kMiB = 1024.0 * 1024;

// A driver may have an interface of the loader, or else only the functions of an application's.
void openDriver(const std::string& library) {
  void* const handle = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(::dlerror());
  for (const char* entry : {"vk_icdGetInstanceProcAddr", "vkGetInstanceProcAddr"}) {
    if (::dlsym(handle, entry) != nullptr) return;
  }
  throw std::runtime_error(library + " is not a Vulkan driver: it has no vk_icdGetInstanceProcAddr");
}

ListedDevices listIn(const std::function<void()>& prepare) {
  const process::ChildResult result = process::runInChild(kListLimit, [&] {
    ::unsetenv("CANDELA_VALIDATION");
    prepare();
    return nlohmann::json(vulkan::listDevices());
  });
  if (result.failure.empty()) return {result.answer.get<std::vector<vulkan::DeviceInfo>>(), ""};
  const bool quote = !result.lastMessage.empty() && !result.failure.starts_with("fails");
  return {{}, quote ? fmt::format("{}, after \"{}\"", result.failure, result.lastMessage) : result.failure};
}

Check checkDevice(const vulkan::DeviceInfo& device) {
  Check check{fmt::format("device {}", device.index), Status::ok, "", ""};
  check.text = fmt::format("{} ({}), driver {}, Vulkan {}", device.name, device.isSoftware() ? "software" : device.type,
                           device.driver, device.apiVersion);
  if (device.usable) return check;
  check.status = Status::warning;
  check.text += "; not usable: " + device.whyNot;
  check.remedy = device.compiles ? "choose another device for renders; `candela kernels` reports what this one compiles"
                                 : "install a newer driver of this device, or choose another device";
  return check;
}

Check limitsOf(const vulkan::DeviceInfo& device) {
  return {fmt::format("limits of device {}", device.index), Status::ok,
          fmt::format(
              "memory {:.0f} MiB, storage buffers {:.0f} MiB, texel buffers {} texels, workgroups {} invocations",
              static_cast<double>(device.memoryBytes) / kMiB, static_cast<double>(device.maxStorageBufferRange) / kMiB,
              device.maxTexelBufferElements, device.maxWorkgroupInvocations),
          ""};
}

}  // namespace

ListedDevices listAllDevices() {
  return listIn([] {});
}

ListedDevices listDevicesOf(const std::string& manifest, const std::string& library) {
  return listIn([&] {
    openDriver(library);
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) ::setenv(name, manifest.c_str(), 1);
    ::unsetenv("VK_ADD_DRIVER_FILES");
    for (const char* name : kFilterVariables) ::unsetenv(name);
  });
}

Checks checkDevices(const std::vector<vulkan::DeviceInfo>& devices) {
  Checks checks;
  for (const vulkan::DeviceInfo& device : devices) {
    checks.push_back(checkDevice(device));
    checks.push_back(limitsOf(device));
  }
  return checks;
}

}  // namespace candela::doctor
