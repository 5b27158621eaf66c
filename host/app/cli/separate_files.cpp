// Compares the outputs of a command with each other and with its inputs.
#include "host/app/cli/separate_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/frame_arguments.h"
#include "host/app/cli/option_table.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"
#include "host/job/film/work_report.h"

namespace candela::cli {
namespace {

namespace fs = std::filesystem;

/// A file that a command writes, and the option that names it.
struct Output {
  fs::path file;
  std::string option;
  bool isImage = false;
};

/// Returns the absolute path without links; the part that does not exist stays as written. Empty on failure.
fs::path canonicalPath(const fs::path& file) {
  std::error_code error;
  const fs::path absolute = fs::absolute(file, error);
  return error ? fs::path() : fs::weakly_canonical(absolute, error);
}

/// Returns whether both paths lead to the same file, which need not exist yet.
bool areSameFile(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (a.empty() || b.empty()) return false;
  return fs::equivalent(a, b, ignored) || (!canonicalPath(a).empty() && canonicalPath(a) == canonicalPath(b));
}

/// Returns whether writing replaces a file. Stdout, devices and pipes only receive what is written.
bool replacesFile(const Output& output) {
  std::error_code ignored;
  if (output.file.empty() || image::isStandardOutput(output.file)) return false;
  return !fs::exists(output.file, ignored) || fs::is_regular_file(output.file, ignored);
}

void addFilm(const fs::path& film, const std::string& option, std::vector<Output>& outputs) {
  if (film.empty()) return;
  outputs.push_back({film, option});
  outputs.push_back({film::workFile(film), "the report of " + option});
}

/// Returns the files that the command would write, among them stdout. Folders (--capture, `capture -o`) must be new,
/// and are left out.
std::vector<Output> outputsOf(const Arguments& arguments) {
  std::vector<Output> outputs;
  for (const std::string option :
       {"--json", "--junit", "--markdown", "--svg", "--report", "--diff", "--flip", "--csv"}) {
    const bool isImage = option == "--diff" || option == "--flip";
    for (const std::string& file : valuesOf(arguments, option)) outputs.push_back({file, option, isImage});
  }
  if (const auto* scene = findPart<WrittenSceneArguments>(arguments)) outputs.push_back({scene->generatedFile, "-o"});
  if (const auto* images = findPart<ImageFileArguments>(arguments)) {
    for (const fs::path& image : images->outputs) outputs.push_back({image, settingWords("output"), true});
  }
  const auto* const render = std::get_if<RenderArguments>(&arguments);
  if (render != nullptr) addFilm(render->film.checkpoint, settingWords("checkpoint"), outputs);
  if (const auto* merge = std::get_if<MergeArguments>(&arguments)) addFilm(merge->output, "-o", outputs);
  return outputs;
}

std::vector<Output> replacedFiles(const Arguments& arguments) {
  std::vector<Output> outputs = outputsOf(arguments);
  std::erase_if(outputs, [](const Output& output) { return !replacesFile(output); });
  return outputs;
}

/// An image on stdout may have no other output before or after it.
void requireOneStdout(const Arguments& arguments) {
  std::vector<Output> outputs = outputsOf(arguments);
  std::erase_if(outputs, [](const Output& output) { return !image::isStandardOutput(output.file); });
  if (outputs.size() < 2 || std::ranges::none_of(outputs, &Output::isImage)) return;
  throw UsageError(fmt::format("{} {} and {} {}: an image on stdout must be the only output there; name a file",
                               outputs[0].option, outputs[0].file.string(), outputs[1].option,
                               outputs[1].file.string()));
}

/// Returns the files that the command line names for reading, without a film, or pictures of a sequence, that the
/// render resumes and replaces.
std::vector<fs::path> inputsOf(const Arguments& arguments) {
  const std::vector<std::string>& files = partOf<GeneralArguments>(arguments).files;
  std::vector<fs::path> inputs, films;
  if (const auto* conformance = std::get_if<ConformanceArguments>(&arguments)) {
    for (const auto* lists : {&conformance->baselines, &conformance->skips, &conformance->flakes})
      inputs.insert(inputs.end(), lists->begin(), lists->end());
  }
  if (!std::holds_alternative<GenerateArguments>(arguments)) inputs.insert(inputs.end(), files.begin(), files.end());
  const bool readsFilms = std::holds_alternative<MergeArguments>(arguments) ||
                          std::holds_alternative<FilmArguments>(arguments);
  if (readsFilms) films.assign(files.begin(), files.end());
  if (const auto* render = std::get_if<RenderArguments>(&arguments)) {
    const fs::path& resumed = render->film.resume;
    const bool isReplaced = areSameFile(resumed, render->film.checkpoint) || resumesPictures(*render);
    if (!resumed.empty() && !isReplaced) films.push_back(resumed);
  }
  for (const fs::path& film : films) inputs.insert(inputs.end(), {film, film::workFile(film)});
  return inputs;
}

void requireDistinct(const std::vector<Output>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!areSameFile(outputs[i].file, outputs[j].file)) continue;
      throw UsageError(fmt::format("{}: {} and {} would both write this file; give each its own name",
                                   outputs[i].file.string(), outputs[j].option, outputs[i].option));
    }
  }
}

void requireNoOutput(const std::vector<Output>& outputs, const fs::path& input) {
  for (const Output& output : outputs) {
    if (!areSameFile(output.file, input)) continue;
    throw UsageError(fmt::format("{}: this file is read by the command, and {} would overwrite it; choose another name",
                                 output.file.string(), output.option));
  }
}

}  // namespace

void requireSeparateFiles(const Arguments& arguments) {
  requireOneStdout(arguments);
  const std::vector<Output> outputs = replacedFiles(arguments);
  requireDistinct(outputs);
  for (const fs::path& input : inputsOf(arguments)) requireNoOutput(outputs, input);
}

void requireUnread(const Arguments& arguments, const std::vector<fs::path>& files) {
  const std::vector<Output> outputs = replacedFiles(arguments);
  for (const fs::path& file : files) requireNoOutput(outputs, file);
}

}  // namespace candela::cli
