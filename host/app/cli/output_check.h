// Refuses outputs that cannot be written, before any work is done for them.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "host/app/cli/command_arguments.h"
#include "host/base/log.h"
#include "host/job/film/film_lock.h"

namespace candela::cli {

/// Throws FileError unless the folder exists and a temporary file beside `file` can be created in it. The temporary
/// file is removed. Devices and pipes are not opened.
void requireWritableFile(const std::filesystem::path& file);
/// Throws FileError as requireWritableFile() does for a film file and for the report beside it, and if the film file is
/// a device or a pipe.
void requireWritableFilm(const std::filesystem::path& film);
/// Throws UsageError for an unknown extension and for a terminal that would receive an image, and FileError as
/// requireWritableFile() does.
void requireWritableImage(const std::filesystem::path& file);
/// Returns the lock on the film file of --checkpoint, which must be held until the film is written; nothing without
/// --checkpoint. Throws FileError if the file cannot be written, if it exists and --resume does not continue from it
/// (its samples are not to be lost), or if another render is writing it or the film of --resume.
std::optional<film::FilmLock> lockCheckpoint(const job::FilmPolicy& policy, const Log& log);
/// Throws UsageError if layers (--aov) are requested and there is no EXR or film file, and no display
/// server, that they could be written to.
void requireLayerFile(const RenderArguments& arguments);
/// Checks the file of a report; "-" and "" are accepted.
void requireWritableReport(const std::string& target);

}  // namespace candela::cli
