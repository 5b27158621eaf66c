// Formats results.
#include "host/drivers/conformance/results.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "host/base/counted.h"
#include "host/base/markup.h"
#include "host/base/report_head.h"

namespace candela::conformance {
namespace {

std::string indented(const std::string& text) {
  std::string out = "    ";
  for (const char character : text) out += character == '\n' ? std::string("\n    ") : std::string(1, character);
  return out;
}

std::map<Status, std::size_t> countStatuses(const RunResult& run) {
  std::map<Status, std::size_t> counts;
  for (const CaseResult& one : run.cases) ++counts[one.verdict.status];
  return counts;
}

std::size_t countUnexpected(const RunResult& run) {
  std::size_t count = 0;
  for (const CaseResult& one : run.cases) count += one.verdict.isExpected() ? 0 : 1;
  return count;
}

std::string wordOf(Status status) {
  return status == Status::improvement ? "UnexpectedImprovement" : textOf(Verdict{status});
}

std::string xmlOf(const CaseResult& one) {
  const std::string head = fmt::format("  <testcase classname=\"candela.conformance\" name=\"{}\" time=\"{:.3f}\"",
                                       xmlEscaped(one.name), one.seconds);
  if (one.verdict.status == Status::skip) {
    return fmt::format("{}>\n    <skipped message=\"{}\"/>\n  </testcase>\n", head, xmlEscaped(one.text));
  }
  if (one.verdict.isExpected()) return head + "/>\n";
  return fmt::format("{}>\n    {}\n  </testcase>\n", head, junitFailure(textOf(one.verdict), one.text));
}

}  // namespace

std::string lineOf(const CaseResult& result) {
  const std::string line = fmt::format("{} {} ({:.2f} s)\n", textOf(result.verdict), result.name, result.seconds);
  return result.text.empty() ? line : line + indented(result.text) + "\n";
}

std::string countsOf(const RunResult& run) {
  std::string text;
  for (const auto& [status, count] : countStatuses(run)) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", wordOf(status), count);
  }
  return text.empty() ? "no results" : text;
}

std::string interruptionOf(const RunResult& run, std::size_t caseCount) {
  return fmt::format("interrupted after {} of {}", run.cases.size(), candela::counted(caseCount, "case"));
}

std::string toCsv(const RunResult& run) {
  std::string text;
  for (const CaseResult& one : run.cases) {
    text += fmt::format("{},{},{:.6f}\n", one.name, textOf(one.verdict), one.seconds);
  }
  return text;
}

nlohmann::ordered_json toJson(const RunResult& run, const vulkan::DeviceInfo& device, double seconds) {
  nlohmann::ordered_json json = reportHead("candela-conformance/2");
  json.update({{"device", device.name},
               {"driver", device.driver},
               {"agrees", run.interrupted ? nlohmann::ordered_json() : nlohmann::ordered_json(run.isExpected())},
               {"interrupted", run.interrupted},
               {"compileOnly", run.compilesOnly},
               {"seconds", seconds}});
  json["counts"] = nlohmann::ordered_json::object();
  for (const auto& [status, count] : countStatuses(run)) json["counts"][wordOf(status)] = count;
  json["cases"] = nlohmann::ordered_json::array();
  for (const CaseResult& one : run.cases) {
    json["cases"].push_back({{"name", one.name},
                             {"result", textOf(one.verdict)},
                             {"agrees", one.verdict.isExpected()},
                             {"seconds", one.seconds},
                             {"text", one.text}});
  }
  return json;
}

std::string toJunit(const RunResult& run, const vulkan::DeviceInfo& device, double seconds) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format(
      "<testsuite name=\"candela conformance{} {}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
      run.compilesOnly ? " --compile-only" : "", xmlEscaped(device.name), run.cases.size(), countUnexpected(run),
      countStatuses(run)[Status::skip], seconds);
  for (const CaseResult& one : run.cases) xml += xmlOf(one);
  return xml + "</testsuite>\n";
}

}  // namespace candela::conformance
