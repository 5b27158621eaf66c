// Reads the pictures and times of several tracers.
#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/json_value.h"
#include "host/base/statistics/quantiles.h"
#include "host/measure/bench/error_report.h"
#include "host/measure/bench/report_file.h"

namespace candela::bench {
namespace {

constexpr const char* kSchema = "candela-error-runs/1";
constexpr std::size_t kMinPictures = 2;

std::filesystem::path fileOf(const JsonValue& name, const std::filesystem::path& folder) {
  return folder / name.text();
}

double positive(const JsonValue& value) {
  if (value.number() > 0) return value.number();
  value.fail("expected a positive number of seconds");
}

std::vector<JsonValue> picturesIn(const JsonValue& tracer, const char* key) {
  const JsonValue list = tracer.require(key);
  if (list.size() < kMinPictures) list.fail("expected at least two pictures of different seeds");
  return list.items();
}

double medianOf(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  return statistics::median(seconds);
}

ErrorReference referenceIn(const JsonValue& tracer, const std::filesystem::path& folder) {
  std::vector<image::Image> pictures;
  for (const JsonValue& file : picturesIn(tracer, "reference"))
    pictures.push_back(image::readImage(fileOf(file, folder)));
  return errorReferenceOf(pictures);
}

ErrorRow rowIn(const JsonValue& tracer, const std::string& scene, const std::filesystem::path& folder) {
  ErrorRow row;
  row.scene = scene;
  row.tracer = tracer.require("tracer").text();
  row.version = tracer.textOr("tracerVersion", "");
  row.samplesPerPixel = tracer.require("samplesPerPixel").whole();
  row.reference = referenceIn(tracer, folder);
  std::vector<double> errors, seconds, processorSeconds;
  for (const JsonValue& picture : picturesIn(tracer, "pictures")) {
    errors.push_back(relMseOf(image::readImage(fileOf(picture.require("file"), folder)), row.reference));
    seconds.push_back(positive(picture.require("seconds")));
    if (const auto value = picture.find("processorSeconds")) processorSeconds.push_back(positive(*value));
  }
  const std::optional<ErrorInTime> error = errorInTime(errors, seconds);
  if (!error) tracer.fail("the pictures have no more noise than the reference, so that they have no error to compare");
  row.error = *error;
  row.pictureCount = errors.size();
  row.medianSeconds = medianOf(seconds);
  if (processorSeconds.size() != errors.size()) return row;
  row.medianProcessorSeconds = medianOf(processorSeconds);
  row.processorError = errorInTime(errors, processorSeconds);
  return row;
}

void readDocument(const std::filesystem::path& document, ErrorReport& report) {
  const nlohmann::json json = readReport(document);
  const JsonValue root(json, "");
  const JsonValue schema = root.require("schema");
  if (schema.text() != kSchema) schema.fail(fmt::format("expected {}", kSchema));
  const std::string scene = root.require("scene").text();
  const std::size_t first = report.rows.size();
  for (const JsonValue& tracer : root.require("tracers").items()) {
    report.rows.push_back(rowIn(tracer, scene, document.parent_path()));
    report.rows.back().referenceRelMse = relMseOf(report.rows.back().reference, report.rows[first].reference);
  }
}

}  // namespace

ErrorReport readErrorRuns(std::span<const std::filesystem::path> documents) {
  ErrorReport report;
  for (const std::filesystem::path& document : documents) {
    try {
      readDocument(document, report);
    } catch (const JsonError& error) {
      throw FileError(fmt::format("{}: not a list of pictures and times: {}", document.string(), error.what()));
    } catch (const UsageError& error) {  // sizes that differ
      throw FileError(fmt::format("{}: {}", document.string(), error.what()));
    }
  }
  return report;
}

}  // namespace candela::bench
