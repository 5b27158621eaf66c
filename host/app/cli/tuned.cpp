// Finds the stored result for a device.
#include "host/app/cli/tuned.h"

#include <fmt/format.h>

#include "host/job/cache/cache_folder.h"

namespace candela::cli {

std::optional<KeptTuning> keptTuning(const vulkan::DeviceInfo& info, const Log& log) {
  const std::optional<std::filesystem::path> folder = cache::cacheFolder();
  if (!folder) return std::nullopt;
  const cache::DeviceKey key = cache::keyOf(info);
  const std::filesystem::path file = *folder / cache::fileNameOf("tune", key, "json");
  const tune::TuningLookup found = tune::readTuning(file, key, info);
  if (!found.problem.empty()) {
    log.warning(fmt::format("{} is ignored: {}; `candela tune` replaces it", file.string(), found.problem));
  }
  if (!found.tuning) return std::nullopt;
  return KeptTuning{*found.tuning, file};
}

render::AutomaticChoices automaticChoices(const TracingArguments& arguments, const vulkan::DeviceInfo& info,
                                          const Log& log) {
  if (arguments.untuned) return {};
  const std::optional<KeptTuning> kept = keptTuning(info, log);
  if (!kept) return {};
  render::AutomaticChoices choices = tune::choicesOf(kept->tuning.candidate);
  choices.origin = fmt::format("tuned {}, {}", kept->tuning.date, kept->file.string());
  return choices;
}

}  // namespace candela::cli
