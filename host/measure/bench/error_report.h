// The error in equal time of several tracers, from pictures and times that they have left in files.
#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/measure/bench/picture_error.h"

namespace candela::bench {

/// The pictures of one scene by one tracer.
struct ErrorRow {
  std::string scene;
  std::string tracer;   ///< name and settings
  std::string version;  ///< of the tracer
  std::uint64_t samplesPerPixel = 0;
  std::uint64_t pictureCount = 0;
  double medianSeconds = 0;
  std::optional<double> medianProcessorSeconds;  ///< absent unless stated for every picture
  ErrorInTime error;                             ///< by the clock
  std::optional<ErrorInTime> processorError;     ///< in equal processor time of all threads
  ErrorReference reference;
  /// relMSE of the reference relative to that of the scene's first tracer, without the noise of both: their difference
  /// in equal pictures is 0 within noise, and may be negative.
  double referenceRelMse = 0;
};

struct ErrorReport {
  std::vector<ErrorRow> rows;  ///< the rows of one scene are consecutive
};

/// Reads the pictures that documents of the schema `candela-error-runs/1` (docs/json.md) list. Files are relative to
/// the folder of their document. Throws FileError, which names the document or the picture.
ErrorReport readErrorRuns(std::span<const std::filesystem::path> documents);

/// Returns e.g. "7.53 % (7.31 to 7.76)".
std::string percentText(const ConfidentValue& fraction);

std::string toText(const ErrorReport& report);
std::string toMarkdown(const ErrorReport& report);
nlohmann::ordered_json toJson(const ErrorReport& report);

/// Adds NAME, NAMELow and NAMEHigh to an object: an estimate and its interval of 95 % confidence.
void addInterval(const std::string& name, const ConfidentValue& estimate, nlohmann::ordered_json& json);

}  // namespace candela::bench
