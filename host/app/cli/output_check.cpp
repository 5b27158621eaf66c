// Checks output files.
#include "host/app/cli/output_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "host/app/cli/option_table.h"
#include "host/base/atomic_file.h"
#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/image/image.h"
#include "host/job/film/work_report.h"

namespace candela::cli {
namespace {

bool areSame(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

void requireRegular(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored) || std::filesystem::is_regular_file(file, ignored)) return;
  throw FileError(fmt::format("{}: a film is written to a regular file only", file.string()));
}

void requireAbsent(const std::filesystem::path& film) {
  std::error_code ignored;
  if (!std::filesystem::exists(film, ignored)) return;
  throw FileError(fmt::format("{}: the file exists, and its samples would be lost; continue it with {}, or remove it",
                              film.string(), settingWords("resume", film.string())));
}

}  // namespace

void requireWritableFile(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw FileError(fmt::format("{}: is a folder", file.string()));
  if (!std::filesystem::is_directory(folder, ignored)) {
    throw FileError(fmt::format("{}: there is no folder {}", file.string(), folder.string()));
  }
  // Devices and pipes are written in place; all other files are renamed into their folder.
  const bool inPlace = std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored);
  if (access(inPlace ? file.c_str() : folder.c_str(), W_OK) != 0) {
    const char* const cause = errno == EROFS ? "the file system is read-only" : "no permission to write there";
    throw FileError(fmt::format("{}: {}", file.string(), cause));
  }
  // Permissions say nothing about file systems that accept no new file, such as /proc.
  if (!inPlace) const AtomicFile trial(file);
}

void requireWritableFilm(const std::filesystem::path& film) {
  requireWritableFile(film);
  requireRegular(film);
  requireWritableFile(film::workFile(film));
}

void requireWritableImage(const std::filesystem::path& file) {
  image::checkImageFormat(file);
  if (!image::isStandardOutput(file)) return requireWritableFile(file);
  if (isatty(STDOUT_FILENO) == 0) return;
  throw UsageError(
      fmt::format("-o {}: stdout is a terminal; redirect it to a file or to another program", file.string()));
}

std::optional<film::FilmLock> lockCheckpoint(const job::FilmPolicy& policy, const Log& log) {
  const std::filesystem::path& file = policy.checkpoint;
  const bool continuesFile = areSame(file, policy.resume);
  if (!policy.resume.empty() && !continuesFile) film::requireUnlocked(policy.resume);
  if (file.empty()) return std::nullopt;
  requireWritableFilm(file);
  film::FilmLock lock(file);  // before the next check, since another render may be about to create the film
  if (!lock.isHeld()) log.detail(fmt::format("{}: cannot be locked against other renders", file.string()));
  if (!continuesFile) requireAbsent(file);
  return lock;
}

void requireLayerFile(const RenderArguments& arguments) {
  if (arguments.request.image.layers.isEmpty()) return;
  if (!arguments.film.checkpoint.empty() || arguments.displayServer) return;
  if (std::ranges::any_of(arguments.outputs, image::isExr)) return;
  throw UsageError("layers are written to EXR and film files only; add -o FILE.exr or --checkpoint FILE");
}

void requireWritableReport(const std::string& target) {
  if (!target.empty() && target != "-") requireWritableFile(target);
}

}  // namespace candela::cli
