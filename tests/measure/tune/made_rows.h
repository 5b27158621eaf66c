// Rows of artificial measurements.
#pragma once
#include <vector>

#include "host/measure/tune/search.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::tune {

/// Times of one scene: the median of the runs, which lie evenly around it by the fraction `deviation`.
struct MadeTime {
  double seconds = 1;
  double deviation = 0;
  bool agrees = true;
};

inline Row madeRow(const Candidate& candidate, const std::vector<MadeTime>& times, std::uint32_t repeats = 3) {
  Row row{candidate, {}};
  for (const MadeTime& time : times) {
    bench::RenderRow scene{"made", 1, {.variant = {"made", render::defaultSettings()}}};
    for (std::uint32_t run = 0; run < repeats; ++run) {
      const double place = repeats == 1 ? 0 : 2.0 * run / (repeats - 1) - 1;
      scene.measurement.traceSeconds.push_back(time.seconds * (1 + place * time.deviation));
    }
    scene.measurement.agrees = time.agrees;
    scene.measurement.variant.settings.image.size = {4, 4};
    row.scenes.push_back(std::move(scene));
  }
  return row;
}

/// Returns the built-in candidate with other values for some options, by their names.
inline Candidate candidateWith(const std::vector<std::pair<std::string, std::string>>& values) {
  Candidate candidate = builtIn();
  for (std::size_t i = 0; i < candidate.size(); ++i) {
    for (const auto& [option, value] : values) {
      if (dimensionTable()[i].option == option) candidate[i] = valueNamed(dimensionTable()[i], value).value();
    }
  }
  return candidate;
}

/// A device that supports all workgroups that are tried.
inline vulkan::DeviceInfo roomyDevice() {
  vulkan::DeviceInfo info;
  info.name = "made device";
  info.driver = "made driver 1.2";
  info.maxWorkgroupInvocations = 1024;
  for (std::uint32_t& side : info.maxWorkgroupSize) side = 1024;
  return info;
}

}  // namespace candela::tune
