// Reads and writes results of tuning.
#include "host/measure/tune/tuning_file.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>

#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/base/json_value.h"
#include "host/base/report_head.h"
#include "host/job/cache/read_file.h"

namespace candela::tune {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kSchema = "candela-tune/1";
constexpr std::size_t kMaxFileSize = std::size_t{1} << 16;

// The date is printed, so that nothing but a date is accepted.
bool isDate(const std::string& text) {
  constexpr std::string_view kPattern = "0000-00-00T00:00:00Z";
  return text.size() == kPattern.size() && std::equal(text.begin(), text.end(), kPattern.begin(), [](char c, char p) {
           return p == '0' ? c >= '0' && c <= '9' : c == p;
         });
}

// Requires exactly one known value of each dimension.
Candidate candidateIn(const JsonValue& choice) {
  if (choice.keys().size() != dimensionTable().size()) choice.fail("expected a value for each tuned option");
  Candidate candidate;
  for (const Dimension& dimension : dimensionTable()) {
    const JsonValue name = choice.require(dimension.option);
    const std::optional<std::size_t> value = valueNamed(dimension, name.text());
    if (!value) name.fail(fmt::format("expected a value of --{}", dimension.option));
    candidate.push_back(*value);
  }
  return candidate;
}

std::string dateIn(const JsonValue& date) {
  if (!isDate(date.text())) date.fail("expected a date");
  return date.text();
}

TuningLookup refuse(std::string problem) { return {std::nullopt, std::move(problem)}; }

TuningLookup parse(const std::string& text, const cache::DeviceKey& key, const vulkan::DeviceInfo& info) {
  try {
    const nlohmann::json file = parseJson(text);
    const JsonValue root(file, "");
    if (root.require("schema").text() != kSchema) return refuse("it was written by another version of Candela");
    if (root.require("key").json() != parseJson(cache::toText(key))) {
      return refuse("it is for another device, driver or set of kernels");
    }
    const Tuning tuning{candidateIn(root.require("choice")), dateIn(root.require("date"))};
    if (!isFeasible(tuning.candidate, info)) return refuse("the device does not support its settings");
    return {tuning, ""};
  } catch (const JsonSyntaxError&) {
    return refuse("it is damaged");
  } catch (const JsonError& error) {
    return refuse(fmt::format("it is damaged: {}", error.what()));
  }
}

}  // namespace

TuningLookup readTuning(const fs::path& file, const cache::DeviceKey& key, const vulkan::DeviceInfo& info) {
  std::string problem;
  const std::optional<std::string> text = cache::readRegularFile(file, kMaxFileSize, problem);
  return text ? parse(*text, key, info) : refuse(problem);
}

void requireTuningFile(const fs::path& file) {
  const auto fail = [&](const std::string& cause) {
    throw FileError(fmt::format("cannot write \"{}\": {}", file.string(), cause));
  };
  std::error_code error;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) fail("it is not a regular file");
  fs::path existing = fs::absolute(file, error).parent_path();
  while (!fs::exists(existing, error) && existing != existing.parent_path()) existing = existing.parent_path();
  if (!fs::is_directory(existing, error)) fail(fmt::format("\"{}\" is not a folder", existing.string()));
  if (::access(existing.c_str(), W_OK | X_OK) != 0) fail(std::generic_category().message(errno));
}

void writeTuning(const fs::path& file, const cache::DeviceKey& key, const Tuning& tuning) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw FileError(fmt::format("cannot create \"{}\": {}", file.parent_path().string(), error.message()));
  ordered_json content = reportHead(kSchema);
  content["date"] = tuning.date;
  content["key"] = cache::toJson(key);
  for (std::size_t i = 0; i < tuning.candidate.size(); ++i) {
    const Dimension& dimension = dimensionTable()[i];
    content["choice"][dimension.option] = dimension.values[tuning.candidate[i]].name;
  }
  const std::string text = jsonText(content, 2) + "\n";
  writeFileAtomically(file, std::as_bytes(std::span(text)));
}

std::string dateNow() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace candela::tune
