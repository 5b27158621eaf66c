// Stores the content of a VkPipelineCache, so that a driver need not compile the kernels again.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/job/cache/device_key.h"

namespace candela::cache {

struct PipelineLookup {
  std::vector<std::byte> data;  ///< for vulkan::Device::loadPipelines(); empty if there is no file, or a problem
  std::string problem;          ///< why the file must not be used; completes "FILE is ignored: "
};

/// Reads a file of writePipelines(). Drivers trust the content of their pipeline caches, so a file is used only if its
/// key, size and checksum are right.
PipelineLookup readPipelines(const std::filesystem::path& file, const DeviceKey& key);

/// Creates or replaces the file atomically, and creates its folder. `data` beyond 256 MiB is not written. Throws
/// FileError.
void writePipelines(const std::filesystem::path& file, const DeviceKey& key, std::span<const std::byte> data);

}  // namespace candela::cache
