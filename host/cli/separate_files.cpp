// Compares the outputs of a command with each other and with its inputs.
#include "host/cli/separate_files.h"

#include <fmt/format.h>

#include "host/core/errors.h"
#include "host/core/setting_words.h"
#include "host/film/work_report.h"
#include "host/image/image.h"

namespace candela::cli {
namespace {

namespace fs = std::filesystem;

/// A file that a command writes, and the option that names it.
struct Output {
  fs::path file;
  std::string option;
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

/// Returns the files that the command would write, among them stdout. Folders (--captures, `capture -o`) must be new,
/// and are left out.
std::vector<Output> outputsOf(const Arguments& arguments) {
  std::vector<Output> outputs{{arguments.json, "--json"},         {arguments.junit, "--junit"},
                              {arguments.markdown, "--markdown"}, {arguments.svg, "--svg"},
                              {arguments.report, "--report"},     {arguments.differenceFile, "--diff"},
                              {arguments.flipFile, "--flip"},     {arguments.conformance.csv, "--csv"}};
  const bool writesScene = arguments.command == Command::generate || arguments.command == Command::boxes;
  if (writesScene) outputs.push_back({arguments.generatedFile, "-o"});
  for (const fs::path& image : arguments.outputs) outputs.push_back({image, "-o"});
  addFilm(arguments.film.checkpoint, settingWords("checkpoint"), outputs);
  addFilm(arguments.mergedFilm, "-o", outputs);
  return outputs;
}

std::vector<Output> replacedFiles(const Arguments& arguments) {
  std::vector<Output> outputs = outputsOf(arguments);
  std::erase_if(outputs, [](const Output& output) { return !replacesFile(output); });
  return outputs;
}

/// An image on stdout may have no other output before or after it.
void requireOneStdout(const Arguments& arguments) {
  if (!arguments.writesImageToStdout()) return;
  std::vector<Output> outputs = outputsOf(arguments);
  std::erase_if(outputs, [](const Output& output) { return !image::isStandardOutput(output.file); });
  if (outputs.size() == 1) return;
  throw UsageError(fmt::format("{} {} and {} {}: an image on stdout must be the only output there; name a file",
                               outputs[0].option, outputs[0].file.string(), outputs[1].option,
                               outputs[1].file.string()));
}

/// Returns the files that the command line names for reading, without a film that the render resumes and replaces.
std::vector<fs::path> inputsOf(const Arguments& arguments) {
  const ConformanceArguments& conformance = arguments.conformance;
  std::vector<fs::path> inputs;
  for (const auto& files : {conformance.baselines, conformance.skips, conformance.flakes})
    inputs.insert(inputs.end(), files.begin(), files.end());
  if (arguments.command != Command::generate)
    inputs.insert(inputs.end(), arguments.files.begin(), arguments.files.end());
  std::vector<fs::path> films;
  if (arguments.command == Command::merge || arguments.command == Command::film)
    films.assign(arguments.files.begin(), arguments.files.end());
  if (!arguments.film.resume.empty() && !areSameFile(arguments.film.resume, arguments.film.checkpoint))
    films.push_back(arguments.film.resume);
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
