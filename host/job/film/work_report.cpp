// Adds up, writes and reads reports of work.
#include "host/job/film/work_report.h"

#include <unistd.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>

#include "host/base/atomic_file.h"
#include "host/base/json_text.h"
#include "host/base/report_head.h"

namespace candela::film {
namespace {

using Json = nlohmann::json;
using nlohmann::ordered_json;

std::string hostName() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  return name.data();
}

// Throws unless the value is a whole number from 0 on. get() would convert other numbers.
std::uint64_t countIn(const Json& value) { return value.get_ref<const Json::number_unsigned_t&>(); }

// Throws nlohmann's exceptions if the JSON is not that of toJson().
WorkReport fromJson(const Json& json) {
  WorkReport work;
  work.runs = countIn(json.at("runs"));
  work.runsNotCounted = countIn(json.at("runsNotCounted"));
  work.hosts = json.at("hosts").get<std::set<std::string>>();
  for (const auto& [name, count] : json.at("counts").get<std::map<std::string, Json>>()) {
    work.counts[name] = countIn(count);
  }
  work.seconds = json.at("seconds").get<std::map<std::string, double>>();
  return work;
}

WorkReport notCounted() {
  WorkReport work;
  work.runsNotCounted = 1;
  return work;
}

// Reports have some hundred bytes; whatever is much larger is none.
std::string startOf(const std::filesystem::path& file) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 20;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return {};
  std::ifstream input(file, std::ios::binary);
  std::string text(kMaxBytes, '\0');
  input.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, input.gcount())));
  return text;
}

}  // namespace

void WorkReport::add(const WorkReport& other) {
  runs += other.runs;
  runsNotCounted += other.runsNotCounted;
  hosts.insert(other.hosts.begin(), other.hosts.end());
  for (const auto& [name, count] : other.counts) counts[name] += count;
  for (const auto& [phase, time] : other.seconds) seconds[phase] += time;
}

WorkReport workOf(const render::RenderStatistics& statistics) {
  WorkReport work;
  work.runs = 1;
  work.hosts = {hostName()};
  work.counts = {{"samples", statistics.samples},
                 {"badSamples", statistics.badSamples},
                 {"cameraRays", statistics.cameraRays},
                 {"bounceRays", statistics.bounceRays},
                 {"shadowRays", statistics.shadowRays},
                 {"vertices", statistics.vertices},
                 {"traversalSteps", statistics.traversalSteps}};
  if (statistics.treeRays) {
    work.counts["cameraHits"] = statistics.treeRays->cameraHits;
    work.counts["reflectedRays"] = statistics.treeRays->reflected;
    work.counts["refractedRays"] = statistics.treeRays->refracted;
  }
  work.seconds = statistics.seconds;
  return work;
}

ordered_json toJson(const WorkReport& work) {
  return {{"runs", work.runs},
          {"runsNotCounted", work.runsNotCounted},
          {"hosts", work.hosts},
          {"counts", work.counts},
          {"seconds", work.seconds}};
}

ordered_json reportJson(const WorkReport& work) {
  ordered_json json{{"runs", work.runs},
                    {"runsNotCounted", work.runsNotCounted},
                    {"hosts", work.hosts},
                    {"counts", work.counts},
                    {"phaseSeconds", work.seconds}};
  if (const auto bad = work.counts.find("badSamples"); bad != work.counts.end()) {
    json["counts"].erase("badSamples");
    json["counts"]["badSampleCount"] = bad->second;
  }
  return json;
}

std::filesystem::path workFile(const std::filesystem::path& film) {
  std::filesystem::path file = film;
  file += ".json";
  return file;
}

void writeWork(const std::filesystem::path& film, const std::string& check, const WorkReport& work) {
  ordered_json json = reportHead("candela-work/1");
  json["film"] = check;
  json.update(toJson(work));
  const std::string text = jsonText(json, 2) + "\n";
  writeFileAtomically(workFile(film), std::as_bytes(std::span(text)));
}

WorkReport readWork(const std::filesystem::path& film, const std::string& check) try {
  const Json json = parseJson(startOf(workFile(film)));
  if (json.at("film") == check) return fromJson(json);
  return notCounted();
} catch (const FileError&) {
  return notCounted();
} catch (const Json::exception&) {
  return notCounted();
}

}  // namespace candela::film
