// Checks output files.
#include "host/cli/output_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "host/core/errors.h"
#include "host/image/image.h"

namespace candela::cli {
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
    throw FileError(fmt::format("{}: no permission to write there", file.string()));
  }
}

void requireWritableImage(const std::filesystem::path& file) {
  image::checkImageFormat(file);
  requireWritableFile(file);
}

void requireCheckpoint(const Arguments& arguments) {
  const std::filesystem::path& file = arguments.checkpoint;
  if (file.empty()) return;
  requireWritableFile(file);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw FileError(fmt::format("{}: a film is written to a regular file only", file.string()));
  }
  if (!arguments.resume.empty() && std::filesystem::equivalent(file, arguments.resume, ignored)) return;
  throw FileError(
      fmt::format("{}: the file exists, and its samples would be lost; continue it with --resume {}, or remove it",
                  file.string(), file.string()));
}

void requireLayerFile(const Arguments& arguments) {
  if (arguments.request.settings.image.layers.isEmpty()) return;
  if (!arguments.checkpoint.empty() || arguments.displayServer) return;
  if (std::ranges::any_of(arguments.outputs, image::isExr)) return;
  throw UsageError("--aov: layers are written to EXR and film files only; add -o FILE.exr or --checkpoint FILE");
}

void requireWritableReport(const std::string& target) {
  if (!target.empty() && target != "-") requireWritableFile(target);
}

}  // namespace candela::cli
