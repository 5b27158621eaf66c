// Compares two reports of a benchmark row by row, to find slowdowns.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace candela::bench {

enum class RowVerdict {
  alike,      ///< within the threshold
  faster,     ///< by more than the threshold
  slower,     ///< by more than the threshold
  undecided,  ///< by more than the threshold, but by less than the spreads of both rows together
  missing,    ///< the new report lacks the row or its score
  added,      ///< the old report lacks the row or its score
  changed,    ///< the scene has changed
};

struct ComparedRow {
  std::string name;                ///< scene and settings
  std::optional<double> oldScore;  ///< millions of rays per second
  std::optional<double> newScore;
  double spread = 0;  ///< maximum of the spreads of both rows
  RowVerdict verdict = RowVerdict::alike;
};

/// Returns whether a row became slower, lost its score or is missing.
bool isRegression(const ComparedRow& row);

struct ReportComparison {
  std::string oldDevice;  ///< device and driver
  std::string newDevice;
  double threshold = 0;
  std::vector<ComparedRow> rows;  ///< in the order of the old report, then the new rows

  /// Returns whether some row is a regression.
  bool regressed() const;
};

/// Compares rows with equal scene, size, samples, variant, structure, kernel, layout, loads, workgroup and kind of
/// rays. A row is slower if its rays per second fell by more than the fraction `threshold`, and by more than the
/// spreads of both rows may explain. Throws FileError if a report has neither kBenchSchema nor its predecessor;
/// messages call the files `oldName` and `newName`.
ReportComparison compareReports(const nlohmann::json& oldReport, const std::string& oldName,
                                const nlohmann::json& newReport, const std::string& newName, double threshold);

std::string toText(const ReportComparison& comparison);
std::string toMarkdown(const ReportComparison& comparison);
nlohmann::ordered_json toJson(const ReportComparison& comparison);

}  // namespace candela::bench
