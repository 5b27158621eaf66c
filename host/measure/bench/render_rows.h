// Renders that were measured, and what all reports on them share: the rows of JSON, and the line above a table.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/measure/bench/measure.h"

namespace candela::bench {

inline constexpr const char* kBenchSchema = "candela-bench/2";

/// The renders of one scene with one variant.
struct RenderRow {
  std::string scene;
  std::uint64_t sceneHash = 0;
  Measurement measurement;
  std::optional<double> publishedSeconds{};  ///< seconds published elsewhere for the same work
};

/// The renders of a benchmark. Each kind of benchmark shows other columns.
struct RenderRows {
  std::uint32_t repeats = 1;
  std::vector<RenderRow> rows{};  ///< at least one; the rows of one scene are consecutive

  /// Returns whether all variants of each image gave the same film.
  bool agree() const;
};

/// A row whose film differs has no figures.
nlohmann::ordered_json toJson(const RenderRow& row);
nlohmann::ordered_json rowsJson(const RenderRows& report);

/// Returns the fields of a report besides its rows: head, device, driver, repeats and whether the results agree.
nlohmann::ordered_json reportJson(const std::string& schema, const std::string& device, const std::string& driver,
                                  std::uint32_t repeats, bool agrees);

/// Returns these fields for a benchmark of renders, whose schema is kBenchSchema.
nlohmann::ordered_json reportJson(const RenderRows& report);

/// Returns e.g. "candela 0.1.0 on llvmpipe, Mesa 22.3.6; median of 3, runs interleaved" for these rows; see
/// repetitionText(). The statistics are those of any row.
std::string headline(const render::RenderStatistics& statistics, std::uint32_t repeats,
                     std::span<const RenderRow> rows);
std::string headline(const RenderRows& report);

}  // namespace candela::bench
