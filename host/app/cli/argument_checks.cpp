// Refuses arguments that contradict each other, need others, or would have no effect.
#include "host/app/cli/argument_checks.h"

#include <fmt/format.h>

#include "host/app/cli/commands.h"
#include "host/app/cli/file_kinds.h"
#include "host/app/cli/frame_arguments.h"
#include "host/app/cli/option_table.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::cli {
namespace {

void requireFileCount(Command command, const GeneralArguments& arguments) {
  const CommandInfo& info = commandInfo(command);
  const std::size_t count = arguments.files.size();
  if (count < info.minFileCount) throw UsageError(fmt::format("no {} given", info.fileNoun));
  if (count > info.maxFileCount)
    throw UsageError(fmt::format("too many arguments: {} is unexpected", arguments.files.back()));
}

// Options for tracing do not affect the comparison of two images, and those for images not that of two tracers. They
// are refused, since ignoring them would hide a misunderstanding.
void refuseOptionsOfOtherComparison(const CompareArguments& arguments) {
  const bool ofSets = !arguments.others.empty();
  if (!ofSets && arguments.files.size() > 2) {
    throw UsageError(fmt::format("too many arguments: {} is unexpected; {} names the renders of a second set",
                                 arguments.files[2], settingWords("with")));
  }
  for (const char* option : {"--tolerance", "--channels"}) {
    if (ofSets && arguments.given.contains(option))
      throw UsageError(fmt::format("{} is for comparing two images, not two sets of renders", option));
  }
  const bool ofImages = ofSets || arguments.files.size() == 2;
  for (const Option& option : optionTable()) {
    const bool tracing = option.group == OptionGroup::image || option.group == OptionGroup::sceneFile ||
                         option.group == OptionGroup::execution;
    const bool imaging = option.group == OptionGroup::comparison || option.group == OptionGroup::output;
    if (!(ofImages ? tracing : imaging) || !arguments.given.contains(option.name())) continue;
    throw UsageError(fmt::format("{} is for comparing {}", option.name(),
                                 ofImages ? "one scene, not two images" : "two images, not one scene"));
  }
}

void requireOutput(const RenderArguments& arguments) {
  if (!arguments.outputs.empty() || arguments.printStatistics || !arguments.json.empty()) return;
  if (!arguments.film.checkpoint.empty() || arguments.displayServer) return;
  throw UsageError(
      "no output given: write the image with -o FILE or the film with --checkpoint FILE, or only measure with --stats "
      "or --json FILE");
}

// An option that only completes another one.
void requireTogether(const GeneralArguments& arguments, const std::string& option, const std::string& other) {
  if (!arguments.given.contains("--" + option) || arguments.given.contains("--" + other)) return;
  throw UsageError(fmt::format("{} has no effect without {}", settingWords(option), settingWords(other)));
}

void requireCompleteOptions(const GeneralArguments& arguments) {
  requireTogether(arguments, "checkpoint-every", "checkpoint");
  requireTogether(arguments, "resume-anyway", "resume");
  for (const char* option : {"paired", "with-variance", "with-spp", "set-spp"}) {
    requireTogether(arguments, option, "with");
  }
}

// An animation has no effect on a scene at rest.
void requireTime(const GeneralArguments& arguments) {
  if (!arguments.given.contains("--frames")) requireTogether(arguments, "animation", "time");
}

void requirePattern(const std::string& option, const std::filesystem::path& file) {
  if (file.empty() || job::isFramePattern(file)) return;
  throw UsageError(fmt::format("{} {}: the name lacks a place for the number of the frame, as in frame.####.png",
                               settingWords(option), file.string()));
}

void requirePatterns(const RenderArguments& arguments) {
  for (const std::filesystem::path& output : arguments.outputs) requirePattern("output", output);
  requirePattern("checkpoint", arguments.film.checkpoint);
  requirePattern("resume", arguments.film.resume);
  requirePattern("json", arguments.json);
}

void requireSequence(const RenderArguments& arguments) {
  if (!arguments.isSequence()) {
    requireTogether(arguments, "fps", "frames");
    if (arguments.seedIsFrame) throw UsageError(settingWords("seed", "frame") + " needs " + settingWords("frames"));
    return;
  }
  if (arguments.loadOptions.time && hasTimes(arguments)) {
    throw UsageError(fmt::format("{} and {} both state the time of a frame", settingWords("time"),
                                 settingWords(arguments.frames ? "frames" : "fps")));
  }
  requirePatterns(arguments);
}

void requireFilmFormat(const std::filesystem::path& film) {
  if (film == "-") throw UsageError("-: a film is not written to stdout; name a file");
  refuseOtherFormat(film, {".exr"}, "a film is an OpenEXR file");
}

void requireTreeDepth(const RequestArguments& arguments) {
  const bool tooDeep = arguments.request.maxDepth && *arguments.request.maxDepth > render::kMaxTreeDepth;
  if (arguments.request.image.integrator != render::Integrator::whitted || !tooDeep) return;
  throw UsageError(fmt::format("{}: the maximum of Whitted ray tracing is {}",
                               settingWords("max-depth", fmt::to_string(*arguments.request.maxDepth)),
                               render::kMaxTreeDepth));
}

void requireOneReaderOfStdout(const Arguments& arguments) {
  std::string first;
  for (const std::string option : {"--stats", "--markdown", "--svg", "--csv", "--junit", "--json"}) {
    const std::vector<std::string> values = valuesOf(arguments, option);
    const bool isText = option == "--stats";
    if (isText ? values.empty() : values != std::vector<std::string>{"-"}) continue;
    const std::string words = isText ? option : option + " -";
    if (!first.empty()) throw UsageError(fmt::format("{} and {} both write to stdout", first, words));
    first = words;
  }
}

}  // namespace

void checkOptions(const Arguments& arguments) {
  requireCompleteOptions(partOf<GeneralArguments>(arguments));
  requireTime(partOf<GeneralArguments>(arguments));
  if (const auto* render = std::get_if<RenderArguments>(&arguments)) requireSequence(*render);
  if (const auto* request = findPart<RequestArguments>(arguments)) requireTreeDepth(*request);
}

void checkArguments(const Arguments& arguments) {
  requireFileCount(commandOf(arguments), partOf<GeneralArguments>(arguments));
  if (const auto* compare = std::get_if<CompareArguments>(&arguments)) refuseOptionsOfOtherComparison(*compare);
  if (const auto* render = std::get_if<RenderArguments>(&arguments)) {
    requireOutput(*render);
    requireCompleteOptions(*render);
    requireFilmFormat(render->film.checkpoint);
  }
  if (const auto* merge = std::get_if<MergeArguments>(&arguments)) {
    if (merge->output.empty()) throw UsageError("no output given: name the merged film with -o FILE");
    requireFilmFormat(merge->output);
  }
  if (const auto* verdict = findPart<VerdictArguments>(arguments)) {
    refuseOtherFormat(verdict->report, {".html", ".htm"}, "the report is an HTML page");
  }
  requireOneReaderOfStdout(arguments);
  checkOptions(arguments);
}

}  // namespace candela::cli
