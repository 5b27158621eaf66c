// Computes keys of devices, and file names from them.
#include "host/job/cache/device_key.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/base/hash.h"
#include "host/base/hash_text.h"
#include "host/base/json_text.h"
#include "host/trace/device/kernel.h"

namespace candela::cache {

DeviceKey keyOf(const vulkan::DeviceInfo& info) {
  return {info.name, info.driver, fmt::to_string(info.driverVersion), info.pipelineCacheUuid,
          std::string(device::kernelsHash())};
}

nlohmann::ordered_json toJson(const DeviceKey& key) {
  return {{"device", key.device},
          {"driver", key.driver},
          {"driverVersion", key.driverVersion},
          {"pipelineCacheUuid", key.pipelineCacheUuid},
          {"kernels", key.kernels}};
}

std::string toText(const DeviceKey& key) { return jsonText(toJson(key)); }

std::string fileNameOf(std::string_view kind, const DeviceKey& key, std::string_view extension) {
  return fmt::format("{}-{}.{}", kind, hashText(fnv1aOfText(toText(key))), extension);
}

}  // namespace candela::cache
