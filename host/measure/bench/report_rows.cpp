// Reads the rows of a report, also those of earlier versions.
#include "host/measure/bench/report_rows.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/base/json_value.h"
#include "host/measure/bench/render_rows.h"

namespace candela::bench {
namespace {

using nlohmann::json;

// The fields that identify a row in both reports, in the order of its name. The number of segments per dispatch is not
// one of them, since by default it is chosen by timing.
constexpr std::array kIdentity{"scene",    "size",       "samplesPerPixel", "variant", "rayKind",    "structure",
                               "bvhSplit", "bvhQuality", "kernel",          "layout",  "sceneLoads", "workgroup"};

/// The schema of earlier versions, whose rows have the same scores.
constexpr const char* kOldSchema = "candela-bench/1";

// Gives a row of an earlier version the names of today.
json renamed(json row) {
  if (const auto kind = row.find("rays"); kind != row.end()) row["rayKind"] = *kind;
  if (const auto layout = row.find("layout"); layout != row.end() && (*layout == "row" || *layout == "none")) {
    *layout = "list";
  }
  return row;
}

std::string nameOf(const json& row) {
  std::string name;
  for (const char* const key : kIdentity) {
    const auto field = row.find(key);
    if (field == row.end()) continue;
    const std::string text = field->is_string() ? field->get<std::string>() : jsonText(*field);
    if (text.empty()) continue;
    if (!name.empty()) name += ", ";
    name += text;
  }
  return name;
}

std::optional<double> numberIn(const JsonValue& row, const char* key) {
  const JsonValue value = row.findOrNull(key);
  return value.isNull() ? std::nullopt : std::optional(value.number());
}

ReportRow rowIn(const JsonValue& row) {
  return {nameOf(renamed(row.json())), row.require("sceneHash").text(), numberIn(row, "mraysPerSecond"),
          numberIn(row, "spread").value_or(0)};
}

}  // namespace

ReportContent readContent(const json& report, const std::string& name) {
  try {
    const JsonValue root(report, "");
    const JsonValue schema = root.require("schema");
    if (schema.text() != kBenchSchema && schema.text() != kOldSchema) schema.fail("it has another schema");
    ReportContent content{root.textOr("device", "") + ", " + root.textOr("driver", ""), {}};
    for (const JsonValue& row : root.require("rows").items()) content.rows.push_back(rowIn(row));
    return content;
  } catch (const JsonError& error) {
    throw FileError(fmt::format("{}: not a report of candela bench: {}", name, error.what()));
  }
}

}  // namespace candela::bench
