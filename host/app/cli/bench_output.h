// Writes reports of benchmarks.
#pragma once
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/json_output.h"
#include "host/app/cli/text_output.h"
#include "host/base/errors.h"

namespace candela::cli {

/// Prints a report of host/measure/bench and writes the files that `bench` or `tune` requests. Logs `complaint` and
/// returns exit code 3 if the measured variants do not agree. The caller writes the chart, if it has one, to `svg`.
template <class Report>
ExitCode publish(const Report& report, const auto& arguments, const Log& log, const char* complaint,
                 std::string_view svg = "") {
  if (wantsText(arguments, {arguments.json, arguments.markdown, svg})) std::cout << toText(report) << std::flush;
  writeText(arguments.markdown, toMarkdown(report));
  writeJson(arguments.json, toJson(report));
  if (report.agree()) return ExitCode::done;
  log.problem(complaint);
  return ExitCode::differ;
}

}  // namespace candela::cli
