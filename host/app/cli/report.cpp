// `candela report RESULTS.json...`: compares devices by the results of the kit.
#include <iostream>
#include <vector>

#include "host/app/cli/commands.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/text_output.h"
#include "host/measure/kit/kit_report.h"

namespace candela::cli {

ExitCode run(const ReportArguments& arguments, const Log&) {
  for (const std::string& target : {arguments.markdown, arguments.svg}) requireWritableReport(target);
  std::vector<kit::KitResults> results;
  for (const std::string& file : arguments.files) results.push_back(kit::readKitResults(file));
  if (wantsText(arguments, {arguments.markdown, arguments.svg})) std::cout << kit::toText(results) << std::flush;
  writeText(arguments.markdown, kit::toMarkdown(results));
  writeText(arguments.svg, kit::toSvg(results));
  return ExitCode::done;
}

}  // namespace candela::cli
