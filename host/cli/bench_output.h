// Writes reports of benchmarks.
#pragma once
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/arguments.h"
#include "host/cli/json_output.h"
#include "host/cli/text_output.h"
#include "host/core/errors.h"

namespace candela::cli {

/// Prints a report of host/bench and writes the requested files. Logs `complaint` and returns exit code 3 if the
/// measured variants do not agree.
template <class Report>
ExitCode publish(const Report& report, const Arguments& arguments, const Log& log, const char* complaint) {
  if (arguments.wantsText()) std::cout << toText(report) << std::flush;
  writeText(arguments.markdown, toMarkdown(report));
  writeJson(arguments.json, toJson(report));
  if (report.agree()) return ExitCode::done;
  log.problem(complaint);
  return ExitCode::differ;
}

}  // namespace candela::cli
