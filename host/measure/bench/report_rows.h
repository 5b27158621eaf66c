// The rows of a report of a benchmark, as far as comparisons need them.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace candela::bench {

struct ReportRow {
  std::string name;  ///< scene and settings, which identify the row in both reports
  std::string sceneHash;
  std::optional<double> score;  ///< millions of rays per second
  double spread = 0;
};

struct ReportContent {
  std::string device;  ///< and driver
  std::vector<ReportRow> rows;
};

/// Throws FileError if the report has neither kBenchSchema nor its predecessor, or if a member is none of such a
/// report. `name` is that of its file.
ReportContent readContent(const nlohmann::json& report, const std::string& name);

}  // namespace candela::bench
