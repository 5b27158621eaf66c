// `candela bench compare OLD.json NEW.json`: finds what became slower.
#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/bench/report_comparison.h"
#include "host/cli/commands.h"
#include "host/cli/json_output.h"
#include "host/cli/text_output.h"

namespace candela::cli {
namespace {

nlohmann::json readJson(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw FileError(file + ": cannot be opened");
  try {
    return nlohmann::json::parse(stream);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace

ExitCode runBenchCompare(const Arguments& arguments, const Log&) {
  const std::string& before = arguments.files[1];
  const std::string& after = arguments.files[2];
  const auto comparison = bench::compareReports(readJson(before), before, readJson(after), after, arguments.threshold);
  if (arguments.wantsText()) std::cout << bench::toText(comparison) << std::flush;
  writeText(arguments.markdown, bench::toMarkdown(comparison));
  writeJson(arguments.json, bench::toJson(comparison));
  return comparison.regressed() ? ExitCode::differ : ExitCode::done;
}

}  // namespace candela::cli
