// `candela bench error RUNS.json...`: compares the errors of tracers in equal time.
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/text_output.h"
#include "host/measure/bench/error_report.h"

namespace candela::cli {

ExitCode runBenchError(const BenchArguments& arguments, const Log&) {
  const std::vector<std::filesystem::path> documents(arguments.files.begin() + 1, arguments.files.end());
  const bench::ErrorReport report = bench::readErrorRuns(documents);
  if (wantsText(arguments, {arguments.json, arguments.markdown})) std::cout << bench::toText(report) << std::flush;
  writeText(arguments.markdown, bench::toMarkdown(report));
  writeJson(arguments.json, bench::toJson(report));
  return ExitCode::done;
}

}  // namespace candela::cli
