// Refuses outputs that cannot be written, before any work is done for them.
#pragma once
#include <filesystem>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// Throws FileError unless the folder exists and is writable.
void requireWritableFile(const std::filesystem::path& file);
/// Throws UsageError for an unknown extension, and FileError as requireWritableFile() does.
void requireWritableImage(const std::filesystem::path& file);
/// Throws FileError if the film file of --checkpoint cannot be written, or if it exists and --resume does not continue
/// from it: its samples are not to be lost.
void requireCheckpoint(const Arguments& arguments);
/// Throws UsageError if layers (--aov) are requested and there is no EXR or film file, and no display
/// server, that they could be written to.
void requireLayerFile(const Arguments& arguments);
/// Checks the file of a report; "-" and "" are accepted.
void requireWritableReport(const std::string& target);

}  // namespace candela::cli
