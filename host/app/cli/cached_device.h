// A device whose compiled pipelines are stored in the cache folder.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/app/cli/arguments.h"
#include "host/base/log.h"
#include "host/job/cache/device_key.h"
#include "host/trace/vulkan/device.h"

namespace candela::cli {

/// Opens the device of `arguments.device` with the pipelines that earlier commands compiled, and stores those of this
/// command when it is destroyed, unless --no-cache is given. The cache never makes a command fail: if it cannot be
/// read or written, the log has the reason, and the file is not changed or is replaced. Throws NoDeviceError.
class CachedDevice {
 public:
  CachedDevice(const OpenDeviceArguments& arguments, const Log& log,
               const std::vector<std::string>& windowExtensions = {});
  CachedDevice(const CachedDevice&) = delete;
  CachedDevice& operator=(const CachedDevice&) = delete;
  ~CachedDevice();

  vulkan::Device& device() { return device_; }

 private:
  void load();
  void store();

  const Log& log_;
  vulkan::Device device_;
  cache::DeviceKey key_;
  std::filesystem::path file_;     ///< empty: nothing is stored
  std::vector<std::byte> stored_;  ///< the data in the file; empty if it cannot be used
};

}  // namespace candela::cli
