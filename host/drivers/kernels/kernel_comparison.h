// Compares two reports of `candela kernels` figure by figure, to find kernels that a driver compiles worse.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/drivers/kernels/figures.h"

namespace candela::kernels {

enum class FigureVerdict {
  changed,  ///< within the threshold, or not judged
  better,   ///< by more than the threshold
  worse,    ///< by more than the threshold
  missing,  ///< the new report lacks a judged figure
};

/// A figure that differs.
struct FigureChange {
  const FigureInfo* figure = nullptr;
  std::optional<double> oldValue;
  std::optional<double> newValue;
  FigureVerdict verdict = FigureVerdict::changed;
};

enum class RowState {
  compared,
  missing,       ///< in the new report
  added,         ///< in the new report
  anotherScene,  ///< under the same name
};

struct ComparedRow {
  std::string name;  ///< scene, kernel and workgroup
  RowState state = RowState::compared;
  std::vector<FigureChange> changes;
};

struct KernelComparison {
  std::string oldDevice;  ///< device and driver
  std::string newDevice;
  bool isOneDriver = true;  ///< false: only figures with one unit for all drivers are compared
  double threshold = 0;
  std::vector<ComparedRow> rows;  ///< in the order of the old report, then the new rows

  /// Returns whether a row is missing, or a figure is missing or worse.
  bool regressed() const;
};

/// Compares rows with equal scene, kernel and workgroup. A figure is worse if it is by more than the fraction
/// `threshold`; any spill is worse than none. Throws FileError if a report does not have kKernelsSchema; messages call
/// the files `oldName` and `newName`.
KernelComparison compareReports(const nlohmann::json& oldReport, const std::string& oldName,
                                const nlohmann::json& newReport, const std::string& newName, double threshold);

std::string toText(const KernelComparison& comparison);
std::string toMarkdown(const KernelComparison& comparison);
nlohmann::ordered_json toJson(const KernelComparison& comparison);

}  // namespace candela::kernels
