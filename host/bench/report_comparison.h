// Two reports of a benchmark, row by row: what became slower.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace candela::bench {

enum class RowVerdict {
  alike,    ///< within the threshold
  faster,   ///< by more than the threshold
  slower,   ///< by more than the threshold
  missing,  ///< only the old report has it, or only there it has a score
  added,    ///< only the new report has it, or only there it has a score
  changed,  ///< the scene is another one
};

struct ComparedRow {
  std::string name;                ///< scene and settings
  std::optional<double> oldScore;  ///< million rays per second
  std::optional<double> newScore;
  double spread = 0;  ///< the larger one of both rows
  RowVerdict verdict = RowVerdict::alike;
};

struct ReportComparison {
  std::string oldDevice;  ///< device and driver
  std::string newDevice;
  double threshold = 0;
  std::vector<ComparedRow> rows;  ///< in the old report's order, then what is new

  /// Whether a row became slower, lost its score or is missing.
  bool regressed() const;
};

/// Rows are the same where scene, size, samples, variant, structure, kernel, layout, loads, workgroup and kind of rays
/// are. A row is slower if its rays per second fell by more than `threshold`, a share of the old ones. Throws FileError
/// for what is no "candela-bench/1"; `oldName` and `newName` are what messages call the files.
ReportComparison compareReports(const nlohmann::json& oldReport, const std::string& oldName,
                                const nlohmann::json& newReport, const std::string& newName, double threshold);

std::string toText(const ReportComparison& comparison);
std::string toMarkdown(const ReportComparison& comparison);
nlohmann::ordered_json toJson(const ReportComparison& comparison);

}  // namespace candela::bench
