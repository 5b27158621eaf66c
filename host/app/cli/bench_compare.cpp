// `candela bench compare OLD.json NEW.json`: finds slowdowns.
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/app/cli/commands.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/text_output.h"
#include "host/measure/bench/report_comparison.h"
#include "host/measure/bench/report_file.h"

namespace candela::cli {
ExitCode runBenchCompare(const BenchArguments& arguments, const Log&) {
  const std::string& before = arguments.files[1];
  const std::string& after = arguments.files[2];
  const auto comparison = bench::compareReports(bench::readReport(before), before, bench::readReport(after), after,
                                                arguments.threshold);
  if (wantsText(arguments, {arguments.json, arguments.markdown, arguments.svg}))
    std::cout << bench::toText(comparison) << std::flush;
  writeText(arguments.markdown, bench::toMarkdown(comparison));
  writeJson(arguments.json, bench::toJson(comparison));
  return comparison.regressed() ? ExitCode::differ : ExitCode::done;
}

}  // namespace candela::cli
