// Reads the rows of a report, also those of earlier versions.
#include "host/bench/report_rows.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "host/bench/render_rows.h"
#include "host/core/errors.h"

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
    const std::string text = field->is_string() ? field->get<std::string>() : field->dump();
    if (text.empty()) continue;
    if (!name.empty()) name += ", ";
    name += text;
  }
  return name;
}

template <class T>
std::optional<T> fieldOf(const json& row, const char* key) {
  const auto field = row.find(key);
  return field == row.end() || field->is_null() ? std::nullopt : std::optional(field->get<T>());
}

}  // namespace

std::vector<ReportRow> readRows(const json& report, const std::string& name) {
  try {
    if (report.at("schema") != kBenchSchema && report.at("schema") != kOldSchema)
      throw FileError(name + ": not a report of candela bench: it has another schema");
    std::vector<ReportRow> rows;
    for (const json& row : report.at("rows")) {
      rows.push_back({nameOf(renamed(row)), row.at("sceneHash").get<std::string>(),
                      fieldOf<double>(row, "mraysPerSecond"), fieldOf<double>(row, "spread").value_or(0)});
    }
    return rows;
  } catch (const json::exception& error) {
    throw FileError(fmt::format("{}: not a report of candela bench: {}", name, error.what()));
  }
}

std::string deviceOf(const json& report) {
  return fieldOf<std::string>(report, "device").value_or("") + ", " +
         fieldOf<std::string>(report, "driver").value_or("");
}

}  // namespace candela::bench
