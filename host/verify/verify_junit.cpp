// The verdict as JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host/core/markup.h"
#include "host/verify/verify_answers.h"

namespace candela::verify {
namespace {

struct JunitCase {
  std::string name;
  bool passed;
  std::string text;  ///< of a failure
};

std::string toXml(const JunitCase& junitCase) {
  const std::string head = fmt::format("  <testcase classname=\"candela.verify\" name=\"{}\"",
                                       xmlEscaped(junitCase.name));
  if (junitCase.passed) return head + "/>\n";
  return fmt::format("{}>\n    {}\n  </testcase>\n", head, junitFailure("Fail", junitCase.text));
}

}  // namespace

std::string toJunit(const VerifyReport& report, bool strict) {
  std::vector<JunitCase> cases{
      {"same numbers, same paths", report.paths.agree(), report.interrupted ? report.verdict() : pathsText(report)},
      {"same light", !report.interrupted && !report.light.differs(), report.verdict()}};
  if (report.exact) cases.push_back({"right light", report.exact->isMet(), exactText(report)});
  if (strict) {
    cases.push_back({"no bad samples", report.badSamples.samples() == 0,
                     fmt::format("{} bad samples", report.badSamples.samples())});
  }
  const auto failures = std::count_if(cases.begin(), cases.end(), [](const JunitCase& c) { return !c.passed; });
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format("<testsuite name=\"candela verify {}\" tests=\"{}\" failures=\"{}\" time=\"{:.3f}\">\n",
                     xmlEscaped(report.scene), cases.size(), failures, report.seconds);
  for (const JunitCase& junitCase : cases) xml += toXml(junitCase);
  return xml + "</testsuite>\n";
}

}  // namespace candela::verify
