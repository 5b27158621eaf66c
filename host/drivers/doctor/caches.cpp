// Examines the folder of compiled pipelines and tuning results.
#include "host/drivers/doctor/caches.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "host/drivers/doctor/resources.h"
#include "host/job/cache/cache_folder.h"
#include "host/job/cache/device_key.h"
#include "host/job/cache/pipeline_file.h"
#include "host/measure/tune/tuning_file.h"

namespace candela::doctor {
namespace {

namespace fs = std::filesystem;

struct Content {
  std::size_t pipelines = 0;
  std::size_t tunings = 0;
  std::uintmax_t bytes = 0;
};

Content contentOf(const fs::path& folder) {
  Content content;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    content.pipelines += name.starts_with("pipelines-") ? 1u : 0u;
    content.tunings += name.starts_with("tune-") ? 1u : 0u;
    std::error_code sizeError;
    const std::uintmax_t size = entry->file_size(sizeError);
    if (!sizeError) content.bytes += size;
  }
  return content;
}

Check checkFolder(const fs::path& folder) {
  const std::string problem = whyNotWritable(folder);
  if (!problem.empty()) {
    return {
        "cache folder", Status::warning,
        fmt::format("{} cannot be written: {}; kernels are compiled again by every command", folder.string(), problem),
        "create this folder with write permission, or name another folder with CANDELA_CACHE_DIR"};
  }
  const Content content = contentOf(folder);
  return {"cache folder", Status::ok,
          fmt::format("{} is writable; files of compiled pipelines: {}, of tuning: {}; {:.1f} MiB", folder.string(),
                      content.pipelines, content.tunings, static_cast<double>(content.bytes) / (1024 * 1024)),
          ""};
}

Check damaged(const std::string& name, const fs::path& file, const std::string& problem) {
  return {name, Status::warning, fmt::format("{} is ignored: {}", file.string(), problem), "delete this file"};
}

Checks checkFiles(const fs::path& folder, const vulkan::DeviceInfo& device) {
  const cache::DeviceKey key = cache::keyOf(device);
  const fs::path pipelineFile = folder / cache::fileNameOf("pipelines", key, "bin");
  const fs::path tuningFile = folder / cache::fileNameOf("tune", key, "json");
  const cache::PipelineLookup pipelines = cache::readPipelines(pipelineFile, key);
  const tune::TuningLookup tuning = tune::readTuning(tuningFile, key, device);
  Check compiled{"compiled pipelines", Status::ok, "none stored for this device; the first render stores them", ""};
  if (!pipelines.problem.empty()) {
    compiled = damaged(compiled.name, pipelineFile, pipelines.problem);
  } else if (!pipelines.data.empty()) {
    compiled.text = fmt::format("{} bytes stored for this device", pipelines.data.size());
  }
  Check tuned{"tuning", Status::ok, "none stored for this device; `candela tune` may make renders faster", ""};
  if (!tuning.problem.empty()) {
    tuned = damaged(tuned.name, tuningFile, tuning.problem);
  } else if (tuning.tuning) {
    tuned.text = fmt::format("{}: {}", tuning.tuning->date, tune::nameOf(tuning.tuning->candidate));
  }
  return {compiled, tuned};
}

}  // namespace

Checks checkCaches(const std::optional<vulkan::DeviceInfo>& device) {
  const std::optional<fs::path> folder = cache::cacheFolder();
  if (!folder) {
    return {{"cache folder", Status::warning, "there is none, since HOME is not set",
             "set HOME, or name a folder with CANDELA_CACHE_DIR"}};
  }
  Checks checks{checkFolder(*folder)};
  if (!device) return checks;
  for (Check& check : checkFiles(*folder, *device)) checks.push_back(std::move(check));
  return checks;
}

}  // namespace candela::doctor
