// Common parts of reports on renders: a row of JSON, and the line above a table.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/bench/measure.h"

namespace candela::bench {

inline constexpr const char* kBenchSchema = "candela-bench/2";

/// Returns the fields that every row of kBenchSchema on renders has. A row whose film differs has no figures.
nlohmann::ordered_json rowJson(const std::string& scene, std::uint64_t sceneHash, const Measurement& measurement);

/// Returns the fields of a report besides its rows: head, device, driver, repeats and whether the results agree.
nlohmann::ordered_json reportJson(const std::string& schema, const std::string& device, const std::string& driver,
                                  std::uint32_t repeats, bool agrees);

/// Returns e.g. "candela 0.1.0 on llvmpipe, Mesa 22.3.6; median of 3, runs interleaved".
std::string headline(const render::RenderStatistics& statistics, std::uint32_t repeats);

}  // namespace candela::bench
