// Loads and stores the compiled pipelines of a device.
#include "host/app/cli/cached_device.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/job/cache/cache_folder.h"
#include "host/job/cache/pipeline_file.h"

namespace candela::cli {

CachedDevice::CachedDevice(const OpenDeviceArguments& arguments, const Log& log,
                           const std::vector<std::string>& windowExtensions)
    : log_(log),
      device_(vulkan::Device::open(arguments.device,
                                   {.hangTimeout = arguments.hangTimeout, .windowExtensions = windowExtensions})),
      key_(cache::keyOf(device_.info())) {
  const std::optional<std::filesystem::path> folder = cache::cacheFolder();
  if (arguments.noCache || !folder) return;
  file_ = *folder / cache::fileNameOf("pipelines", key_, "bin");
  load();
}

CachedDevice::~CachedDevice() {
  try {
    if (!file_.empty() && !device_.hasFailed()) store();
  } catch (const std::exception& error) {
    log_.detail(fmt::format("compiled pipelines are not stored: {}", error.what()));
  }
}

void CachedDevice::load() {
  cache::PipelineLookup found = cache::readPipelines(file_, key_);
  if (!found.problem.empty()) log_.detail(fmt::format("{} is ignored: {}", file_.string(), found.problem));
  stored_ = std::move(found.data);
  if (stored_.empty()) return;
  device_.loadPipelines(stored_);
  log_.detail(fmt::format("compiled pipelines: {} bytes from {}", stored_.size(), file_.string()));
}

void CachedDevice::store() {
  const std::vector<std::byte> data = device_.pipelineData();
  if (data == stored_) return;
  cache::writePipelines(file_, key_, data);
  log_.detail(fmt::format("compiled pipelines: {} bytes to {}", data.size(), file_.string()));
}

}  // namespace candela::cli
