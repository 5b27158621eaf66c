// Where a benchmark's report goes.
#pragma once
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/arguments.h"
#include "host/cli/json_output.h"
#include "host/cli/text_output.h"
#include "host/core/errors.h"

namespace candela::cli {

/// Prints a report of host/bench and writes the files that the command line asks for. Exit code 3, and `complaint` in
/// the log, if what was measured does not agree.
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
