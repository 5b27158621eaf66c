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

/// Throws FileError if the report has neither kBenchSchema nor its predecessor. `name` is that of its file.
std::vector<ReportRow> readRows(const nlohmann::json& report, const std::string& name);
/// Returns the device and the driver of a report.
std::string deviceOf(const nlohmann::json& report);

}  // namespace candela::bench
