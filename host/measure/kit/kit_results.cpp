// Reads results of the kit. Errors name the file and the JSON pointer, since the files come from other machines.
#include "host/measure/kit/kit_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "host/base/json_value.h"
#include "host/measure/bench/report_file.h"

namespace candela::kit {
namespace {

constexpr std::uint64_t kMaxExitCode = 255;
constexpr std::uint64_t kMaxCount = std::numeric_limits<unsigned>::max();

// Numbers that JSON cannot express, such as the speed of a variant whose image differs, are null.
double numberOrZero(const JsonValue& row, const char* key) {
  const JsonValue value = row.findOrNull(key);
  return value.isNull() ? 0 : value.number();
}

// Returns the text of a member that earlier versions call `oldKey`.
std::string text(const JsonValue& object, const std::string& key, const std::string& oldKey) {
  const JsonValue element = object.findOrNull(key);
  return element.isNull() ? object.require(oldKey).text() : element.text();
}

// Returns whether a verdict is positive. It is null if there is none, and earlier versions call it `agree`.
bool agreement(const JsonValue& report) {
  const JsonValue agrees = report.findOrNull("agrees");
  if (!agrees.isNull()) return agrees.boolean();
  const JsonValue earlier = report.findOrNull("agree");
  return !earlier.isNull() && earlier.boolean();
}

// Calls `read` for the items of an array that may be null.
template <class Read>
void forEachItem(const JsonValue& array, Read&& read) {
  if (array.isNull()) return;
  for (const JsonValue& item : array.items()) read(item);
}

void readSteps(const JsonValue& steps, KitResults& results) {
  forEachItem(steps, [&](const JsonValue& step) {
    results.steps.push_back({step.require("name").text(),
                             static_cast<int>(step.require("exitCode").whole(0, kMaxExitCode)),
                             step.require("seconds").number()});
  });
}

bool passed(const std::string& result) { return result == "Pass" || result == "Skip"; }

void readConformance(const JsonValue& report, KitResults& results) {
  if (report.isNull()) return;
  const JsonValue counts = report.findOrNull("counts");
  for (const std::string& key : counts.keys())
    results.caseCounts[key] = static_cast<unsigned>(counts.require(key).whole(0, kMaxCount));
  forEachItem(report.findOrNull("cases"), [&](const JsonValue& one) {
    const std::string result = one.require("result").text();
    if (!passed(result)) results.failedCases.push_back({one.require("name").text(), result});
  });
}

void readVerdicts(const JsonValue& reports, KitResults& results) {
  forEachItem(reports, [&](const JsonValue& report) {
    if (report.isNull()) return;
    results.verdicts.push_back({report.require("scene").text(), agreement(report), report.require("verdict").text()});
  });
}

// Calls `read` for the rows of the reports of all scenes.
template <class Read>
void forEachRow(const JsonValue& reports, Read&& read) {
  forEachItem(reports, [&](const JsonValue& report) {
    if (!report.isNull()) forEachItem(report.findOrNull("rows"), read);
  });
}

void readRenders(const JsonValue& reports, KitResults& results) {
  forEachRow(reports, [&](const JsonValue& row) {
    results.renders.push_back({row.require("scene").text(), row.require("variant").text(),
                               numberOrZero(row, "msamplesPerSecond"), numberOrZero(row, "mraysPerSecond"),
                               numberOrZero(row, "spread")});
  });
}

void readRays(const JsonValue& reports, KitResults& results) {
  forEachRow(reports, [&](const JsonValue& row) {
    results.rays.push_back(
        {row.require("scene").text(), text(row, "rayKind", "rays"),
         fmt::format("layout={} loads={}", row.require("layout").text(), row.require("sceneLoads").text()),
         numberOrZero(row, "mraysPerSecond")});
  });
}

std::string tunedText(const JsonValue& report) {
  if (report.isNull()) return "";
  std::string text;
  const JsonValue chosen = report.findOrNull("chosen");
  for (const std::string& key : chosen.keys())
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, chosen.require(key).text());
  return text;
}

// The reports of all steps name the device; the first one with a result is used.
void readDevice(const JsonValue& root, KitResults& results) {
  std::vector<JsonValue> reports{root.findOrNull("conformance")};
  for (const char* const step : {"verify", "bench", "rays"})
    forEachItem(root.findOrNull(step), [&](const JsonValue& report) { reports.push_back(report); });
  for (const JsonValue& report : reports) {
    if (report.isNull()) continue;
    results.device = report.require("device").text();
    results.driver = report.require("driver").text();
    return;
  }
  root.fail("no step of the kit gave a result");
}

// Keeps the rows with the maximum score among those with equal keys.
template <class Row, class Key, class Score>
std::vector<Row> fastest(const std::vector<Row>& rows, Key&& key, Score&& score) {
  std::vector<Row> kept;
  for (const Row& row : rows) {
    const auto found = std::find_if(kept.begin(), kept.end(), [&](const Row& other) { return key(other) == key(row); });
    if (found == kept.end()) {
      kept.push_back(row);
    } else if (score(row) > score(*found)) {
      *found = row;
    }
  }
  return kept;
}

KitResults resultsFrom(const JsonValue& root) {
  const JsonValue schema = root.findOrNull("schema");
  if (schema.isNull() || (schema.text() != "candela-kit/2" && schema.text() != "candela-kit/1"))
    schema.fail("expected \"candela-kit/2\": not results of the kit");
  KitResults results;
  results.version = root.require("version").text();
  results.system = root.require("system").text();
  results.processor = root.require("processor").text();
  results.quick = root.require("quick").boolean();
  readDevice(root, results);
  readSteps(root.findOrNull("steps"), results);
  readConformance(root.findOrNull("conformance"), results);
  readVerdicts(root.findOrNull("verify"), results);
  readRenders(root.findOrNull("bench"), results);
  readRays(root.findOrNull("rays"), results);
  results.tuned = tunedText(root.findOrNull("tune"));
  return results;
}

}  // namespace

KitResults readKitResults(const std::filesystem::path& file) {
  const nlohmann::json document = bench::readReport(file);
  try {
    return resultsFrom(JsonValue(document, ""));
  } catch (const JsonError& error) {
    throw FileError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<RenderSpeed> fastestRenders(const KitResults& results) {
  return fastest(
      results.renders, [](const RenderSpeed& row) { return row.scene; },
      [](const RenderSpeed& row) { return row.msamplesPerSecond; });
}

std::vector<RaySpeed> fastestRays(const KitResults& results) {
  return fastest(
      results.rays, [](const RaySpeed& row) { return row.scene + '\n' + row.kind; },
      [](const RaySpeed& row) { return row.mraysPerSecond; });
}

}  // namespace candela::kit
