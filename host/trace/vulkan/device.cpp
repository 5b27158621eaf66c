// Opens devices.
#include "host/trace/vulkan/device.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/trace/vulkan/command_recorder_impl.h"
#include "host/trace/vulkan/describe.h"
#include "host/trace/vulkan/device_choice.h"
#include "host/trace/vulkan/device_impl.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {

Device Device::open(const std::string& selector, const DeviceOptions& options) {
  std::optional<Instance> instance = openInstance(options.windowExtensions);
  std::vector<vk::raii::PhysicalDevice> devices;
  if (instance) devices = instance->physicalDevices();
  std::vector<DeviceInfo> infos = describeAll(devices);
  if (options.compilesOnly) allowCompilers(infos);
  const DeviceInfo& info = chooseDevice(infos, selector);
  return Device(guarded("open the device", [&] {
    return std::make_shared<Impl>(std::move(*instance), std::move(devices[info.index]), info, options);
  }));
}

Device Device::open(const DeviceInfo& info, const DeviceOptions& options) {
  Device device = open(std::to_string(info.index), options);
  if (device.info().name != info.name) {
    throw NoDeviceError(fmt::format("Vulkan device {} was \"{}\" and is now \"{}\": devices have changed", info.index,
                                    info.name, device.info().name));
  }
  return device;
}

const DeviceInfo& Device::info() const { return impl_->info; }
bool Device::hasFailed() const { return impl_->hasFailed; }
bool Device::canPresent() const { return impl_->canPresent; }

MemoryUse Device::memoryUse() const { return impl_->memory.use(); }

void Device::loadPipelines(std::span<const std::byte> data) {
  guarded("load compiled pipelines", [&] {
    const vk::PipelineCacheCreateInfo info({}, data.size(), data.data());
    const vk::raii::PipelineCache loaded = impl_->handle.createPipelineCache(info);
    impl_->pipelineCache.merge(*loaded);
  });
}

std::vector<std::byte> Device::pipelineData() const {
  return guarded("read compiled pipelines", [&] {
    const std::vector<std::uint8_t> data = impl_->pipelineCache.getData();
    const std::span bytes = std::as_bytes(std::span(data));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  });
}

double Device::run(const std::function<void(CommandRecorder&)>& record) {
  return impl_->run([&record](const CommandRecorder::Impl& commands) {
    CommandRecorder recorder(commands);
    record(recorder);
  });
}

}  // namespace candela::vulkan
