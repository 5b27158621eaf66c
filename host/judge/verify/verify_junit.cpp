// The verdict as JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host/base/markup.h"
#include "host/judge/verify/verify_answers.h"

namespace candela::verify {
namespace {

enum class CaseOutcome { passed, failed, notDecided, skipped };

struct JunitCase {
  std::string name;
  CaseOutcome outcome;
  std::string text;  ///< of a case that did not pass

  bool fails() const { return outcome == CaseOutcome::failed || outcome == CaseOutcome::notDecided; }
};

CaseOutcome outcomeOf(bool passed) { return passed ? CaseOutcome::passed : CaseOutcome::failed; }

// Returns the outcome of a question that found no difference, if `isOpen` says whether it is undecided.
CaseOutcome outcomeOf(bool agrees, bool isOpen, const JunitOptions& options) {
  if (!agrees || !isOpen) return outcomeOf(agrees);
  return options.allowsUndecided ? CaseOutcome::skipped : CaseOutcome::notDecided;
}

std::string toXml(const JunitCase& junitCase) {
  const std::string head = fmt::format("  <testcase classname=\"candela.verify\" name=\"{}\"",
                                       xmlEscaped(junitCase.name));
  switch (junitCase.outcome) {
    case CaseOutcome::passed:
      return head + "/>\n";
    case CaseOutcome::skipped:
      return fmt::format("{}>\n    <skipped message=\"{}\"/>\n  </testcase>\n", head, xmlEscaped(junitCase.text));
    case CaseOutcome::failed:
    case CaseOutcome::notDecided:
      break;
  }
  const char* const type = junitCase.outcome == CaseOutcome::failed ? "Fail" : "NotDecided";
  return fmt::format("{}>\n    {}\n  </testcase>\n", head, junitFailure(type, junitCase.text));
}

}  // namespace

std::string toJunit(const VerifyReport& report, const JunitOptions& options) {
  const std::string verdict = report.verdict();
  const bool sameLight = !report.interrupted && !report.light.differs();
  const bool isOpen = sameLight && report.doubt() != Doubt::none;
  std::vector<JunitCase> cases{
      {"same numbers, same paths", outcomeOf(report.paths.agree()), report.interrupted ? verdict : pathsText(report)},
      {"same light", outcomeOf(sameLight, isOpen, options), isOpen ? lightText(report) : verdict}};
  if (report.exact) {
    cases.push_back(
        {"right light", outcomeOf(report.exact->isMet(), report.isExactOpen(), options), exactText(report)});
  }
  if (options.strict) {
    cases.push_back({"no bad samples", outcomeOf(report.badSamples.samples() == 0),
                     fmt::format("{} bad samples", report.badSamples.samples())});
  }
  const auto failures = std::count_if(cases.begin(), cases.end(), [](const JunitCase& one) { return one.fails(); });
  const auto skipped = std::ranges::count(cases, CaseOutcome::skipped, &JunitCase::outcome);
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format(
      "<testsuite name=\"candela verify {}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\" time=\"{:.3f}\">\n",
      xmlEscaped(report.scene), cases.size(), failures, skipped, report.seconds);
  for (const JunitCase& junitCase : cases) xml += toXml(junitCase);
  return xml + "</testsuite>\n";
}

}  // namespace candela::verify
