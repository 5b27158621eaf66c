// Formats the results of a run: for people, as deqp-runner's results.csv, as JSON, and as JUnit XML.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/drivers/conformance/runner.h"

namespace candela::conformance {

/// Returns one line: "Pass,control.nested_break", and the text of an unexpected result, indented, below it.
std::string lineOf(const CaseResult& result);
/// Returns the number of cases with each result, e.g. "Pass: 58, ExpectedFail: 2", or "no results".
std::string countsOf(const RunResult& run);
/// Returns how many of `caseCount` cases ended before the interruption, e.g. "interrupted after 4 of 42 cases".
std::string interruptionOf(const RunResult& run, std::size_t caseCount);
/// Returns lines `case,Result,seconds`, sorted by case.
std::string toCsv(const RunResult& run);
nlohmann::ordered_json toJson(const RunResult& run, const vulkan::DeviceInfo& device, double seconds);
/// Returns a JUnit test suite. Unexpected results are failures; skipped cases name the missing feature.
std::string toJunit(const RunResult& run, const vulkan::DeviceInfo& device, double seconds);

}  // namespace candela::conformance
