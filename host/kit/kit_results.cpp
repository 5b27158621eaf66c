// Reads results of the kit. Every access names its JSON pointer in errors, since the files come from other machines.
#include "host/kit/kit_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/bench/report_file.h"
#include "host/core/errors.h"

namespace candela::kit {
namespace {

using nlohmann::json;

// A value inside a results file, with its JSON pointer.
class Element {
 public:
  Element(const json& value, std::string file, std::string pointer)
      : value_(&value), file_(std::move(file)), pointer_(std::move(pointer)) {}

  bool isNull() const { return value_->is_null(); }

  // Returns a member, which is null if the object lacks it.
  Element member(const std::string& key) const {
    static const json null;
    if (!value_->is_object()) fail("an object is expected");
    const auto found = value_->find(key);
    return {found == value_->end() ? null : *found, file_, pointer_ + "/" + key};
  }

  std::vector<Element> items() const {
    if (!value_->is_array()) fail("an array is expected");
    std::vector<Element> items;
    for (const json& item : *value_) items.emplace_back(item, file_, fmt::format("{}/{}", pointer_, items.size()));
    return items;
  }

  std::vector<std::string> keys() const {
    if (!value_->is_object()) fail("an object is expected");
    std::vector<std::string> keys;
    for (const auto& [key, ignored] : value_->items()) keys.push_back(key);
    return keys;
  }

  std::string text() const {
    if (!value_->is_string()) fail("a string is expected");
    return value_->get<std::string>();
  }

  double number() const {
    if (!value_->is_number()) fail("a number is expected");
    return value_->get<double>();
  }

  // Numbers that JSON cannot express, such as the speed of a variant whose image differs, are null.
  double numberOrZero() const { return isNull() ? 0 : number(); }

  bool flag() const {
    if (!value_->is_boolean()) fail("true or false is expected");
    return value_->get<bool>();
  }

  [[noreturn]] void fail(const std::string& complaint) const {
    throw FileError(fmt::format("{}: {}: {}", file_, pointer_.empty() ? "/" : pointer_, complaint));
  }

 private:
  const json* value_;
  std::string file_;
  std::string pointer_;
};

// Returns the text of a member that earlier versions call `oldKey`.
std::string text(const Element& object, const std::string& key, const std::string& oldKey) {
  const Element element = object.member(key);
  return element.isNull() ? object.member(oldKey).text() : element.text();
}

// Returns whether a verdict is positive. It is null if there is none, and earlier versions call it `agree`.
bool agreement(const Element& report) {
  const Element agrees = report.member("agrees");
  if (!agrees.isNull()) return agrees.flag();
  const Element earlier = report.member("agree");
  return !earlier.isNull() && earlier.flag();
}

// Calls `read` for the items of an array that may be null.
template <class Read>
void forEachItem(const Element& array, Read&& read) {
  if (array.isNull()) return;
  for (const Element& item : array.items()) read(item);
}

void readSteps(const Element& steps, KitResults& results) {
  forEachItem(steps, [&](const Element& step) {
    results.steps.push_back({step.member("name").text(), static_cast<int>(step.member("exitCode").number()),
                             step.member("seconds").number()});
  });
}

bool passed(const std::string& result) { return result == "Pass" || result == "Skip"; }

void readConformance(const Element& report, KitResults& results) {
  if (report.isNull()) return;
  const Element counts = report.member("counts");
  for (const std::string& key : counts.keys())
    results.caseCounts[key] = static_cast<unsigned>(counts.member(key).number());
  forEachItem(report.member("cases"), [&](const Element& one) {
    const std::string result = one.member("result").text();
    if (!passed(result)) results.failedCases.push_back({one.member("name").text(), result});
  });
}

void readVerdicts(const Element& reports, KitResults& results) {
  forEachItem(reports, [&](const Element& report) {
    if (report.isNull()) return;
    results.verdicts.push_back({report.member("scene").text(), agreement(report), report.member("verdict").text()});
  });
}

// Calls `read` for the rows of the reports of all scenes.
template <class Read>
void forEachRow(const Element& reports, Read&& read) {
  forEachItem(reports, [&](const Element& report) {
    if (!report.isNull()) forEachItem(report.member("rows"), read);
  });
}

void readRenders(const Element& reports, KitResults& results) {
  forEachRow(reports, [&](const Element& row) {
    results.renders.push_back({row.member("scene").text(), row.member("variant").text(),
                               row.member("msamplesPerSecond").numberOrZero(),
                               row.member("mraysPerSecond").numberOrZero(), row.member("spread").numberOrZero()});
  });
}

void readRays(const Element& reports, KitResults& results) {
  forEachRow(reports, [&](const Element& row) {
    results.rays.push_back(
        {row.member("scene").text(), text(row, "rayKind", "rays"),
         fmt::format("layout={} loads={}", row.member("layout").text(), row.member("sceneLoads").text()),
         row.member("mraysPerSecond").numberOrZero()});
  });
}

std::string tunedText(const Element& report) {
  if (report.isNull()) return "";
  std::string text;
  const Element chosen = report.member("chosen");
  for (const std::string& key : chosen.keys())
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, chosen.member(key).text());
  return text;
}

// The reports of all steps name the device; the first one with a result is used.
void readDevice(const Element& root, KitResults& results) {
  std::vector<Element> reports{root.member("conformance")};
  for (const char* const step : {"verify", "bench", "rays"})
    forEachItem(root.member(step), [&](const Element& report) { reports.push_back(report); });
  for (const Element& report : reports) {
    if (report.isNull()) continue;
    results.device = report.member("device").text();
    results.driver = report.member("driver").text();
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

}  // namespace

KitResults readKitResults(const std::filesystem::path& file) {
  const json document = bench::readReport(file);
  const Element root(document, file.string(), "");
  const Element schema = root.member("schema");
  if (schema.isNull() || (schema.text() != "candela-kit/2" && schema.text() != "candela-kit/1"))
    schema.fail("\"candela-kit/2\" is expected: not results of the kit");
  KitResults results;
  results.version = root.member("version").text();
  results.system = root.member("system").text();
  results.processor = root.member("processor").text();
  results.quick = root.member("quick").flag();
  readDevice(root, results);
  readSteps(root.member("steps"), results);
  readConformance(root.member("conformance"), results);
  readVerdicts(root.member("verify"), results);
  readRenders(root.member("bench"), results);
  readRays(root.member("rays"), results);
  results.tuned = tunedText(root.member("tune"));
  return results;
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
