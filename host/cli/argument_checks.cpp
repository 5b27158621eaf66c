// Refuses arguments that contradict each other, need others, or would have no effect.
#include "host/cli/argument_checks.h"

#include <fmt/format.h>

#include <utility>

#include "host/cli/commands.h"
#include "host/cli/file_kinds.h"
#include "host/cli/option_table.h"
#include "host/core/errors.h"
#include "host/core/setting_words.h"

namespace candela::cli {
namespace {

void requireFileCount(const Arguments& arguments) {
  const CommandInfo& info = commandInfo(arguments.command);
  const std::size_t count = arguments.files.size();
  if (count < info.minFileCount) throw UsageError(fmt::format("no {} given", info.fileNoun));
  if (count > info.maxFileCount)
    throw UsageError(fmt::format("too many arguments: {} is unexpected", arguments.files.back()));
}

// Options for tracing do not affect the comparison of two images. They are refused, since ignoring them would hide a
// misunderstanding.
void refuseTracingOptionsForImages(const Arguments& arguments) {
  if (arguments.command != Command::compare || arguments.files.size() != 2) return;
  for (const Option& option : optionTable()) {
    const bool tracing = option.group == OptionGroup::image || option.group == OptionGroup::sceneFile ||
                         option.group == OptionGroup::execution;
    if (tracing && arguments.given.contains(option.name())) {
      throw UsageError(fmt::format("{} is for comparing one scene, not two images", option.name()));
    }
  }
}

void refuseImageOptionsForScene(const Arguments& arguments) {
  if (arguments.command != Command::compare || arguments.files.size() != 1) return;
  for (const Option& option : optionTable()) {
    const bool imaging = option.group == OptionGroup::comparison || option.group == OptionGroup::output;
    if (imaging && arguments.given.contains(option.name())) {
      throw UsageError(fmt::format("{} is for comparing two images, not one scene", option.name()));
    }
  }
}

void requireOutput(const Arguments& arguments) {
  if (arguments.command != Command::render) return;
  if (!arguments.outputs.empty() || arguments.printStatistics || !arguments.json.empty()) return;
  if (!arguments.film.checkpoint.empty() || arguments.displayServer) return;
  throw UsageError(
      "no output given: write the image with -o FILE or the film with --checkpoint FILE, or only measure with --stats "
      "or --json FILE");
}

// An option that only completes another one.
void requireTogether(const Arguments& arguments, const std::string& option, const std::string& other) {
  if (!arguments.given.contains("--" + option) || arguments.given.contains("--" + other)) return;
  throw UsageError(fmt::format("{} has no effect without {}", settingWords(option), settingWords(other)));
}

void requireCompleteOptions(const Arguments& arguments) {
  requireTogether(arguments, "checkpoint-every", "checkpoint");
  requireTogether(arguments, "resume-anyway", "resume");
  requireTogether(arguments, "animation", "time");
}

void requireFormats(const Arguments& arguments) {
  for (const auto& film : {arguments.mergedFilm, arguments.film.checkpoint}) {
    if (film == "-") throw UsageError("-: a film is not written to stdout; name a file");
    refuseOtherFormat(film, {".exr"}, "a film is an OpenEXR file");
  }
  refuseOtherFormat(arguments.report, {".html", ".htm"}, "the report is an HTML page");
}

void requireMergedFilm(const Arguments& arguments) {
  if (arguments.command == Command::merge && arguments.mergedFilm.empty()) {
    throw UsageError("no output given: name the merged film with -o FILE");
  }
}

void requireTreeDepth(const Arguments& arguments) {
  const bool tooDeep = arguments.request.maxDepth && *arguments.request.maxDepth > render::kMaxTreeDepth;
  if (arguments.request.image.integrator != render::Integrator::whitted || !tooDeep) return;
  throw UsageError(fmt::format("{}: the maximum of Whitted ray tracing is {}",
                               settingWords("max-depth", fmt::to_string(*arguments.request.maxDepth)),
                               render::kMaxTreeDepth));
}

void requireOneReaderOfStdout(const Arguments& arguments) {
  const std::pair<const char*, bool> writers[]{
      {"--stats", arguments.printStatistics}, {"--markdown -", arguments.markdown == "-"},
      {"--svg -", arguments.svg == "-"},      {"--csv -", arguments.conformance.csv == "-"},
      {"--junit -", arguments.junit == "-"},  {"--json -", arguments.json == "-"}};
  const char* first = nullptr;
  for (const auto& [option, writes] : writers) {
    if (!writes) continue;
    if (first != nullptr) throw UsageError(fmt::format("{} and {} both write to stdout", first, option));
    first = option;
  }
}

}  // namespace

void checkOptions(const Arguments& arguments) {
  requireCompleteOptions(arguments);
  requireTreeDepth(arguments);
}

void checkArguments(const Arguments& arguments) {
  requireFileCount(arguments);
  refuseTracingOptionsForImages(arguments);
  refuseImageOptionsForScene(arguments);
  requireOutput(arguments);
  requireCompleteOptions(arguments);
  requireMergedFilm(arguments);
  requireFormats(arguments);
  requireOneReaderOfStdout(arguments);
  requireTreeDepth(arguments);
}

}  // namespace candela::cli
