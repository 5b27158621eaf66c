// What reports of renders share: a row of JSON, and the line above a table.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/bench/measure.h"

namespace candela::bench {

/// The fields that every row of "candela-bench/1" with renders has; a row whose film differs has no figures.
nlohmann::ordered_json rowJson(const std::string& scene, std::uint64_t sceneHash, const Measurement& measurement);

/// What every report has beside its rows: schema, version, device, driver and repeats.
nlohmann::ordered_json reportJson(const std::string& device, const std::string& driver, std::uint32_t repeats);

/// E.g. "candela 0.1.0 on llvmpipe, Mesa 22.3.6; median of 3, runs interleaved".
std::string headline(const render::RenderStatistics& statistics, std::uint32_t repeats);

}  // namespace candela::bench
