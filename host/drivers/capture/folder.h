// The folder of a capture: a C program with its data, and how to reduce the shader.
#pragma once
#include <filesystem>

#include "host/drivers/capture/capture.h"

namespace candela::capture {

/// Throws FileError unless `folder` is an empty folder, or does not exist while its parent is a writable folder.
void requireNewFolder(const std::filesystem::path& folder);

/// Writes the folder under a temporary name beside it, and renames it at the end, so that it appears completely or not
/// at all. Throws as requireNewFolder() does, FileError if a file cannot be written, and UsageError if the work has
/// more objects than reproduce.c takes.
void writeFolder(const Capture& capture, const std::filesystem::path& folder);

/// Removes what a process that was ended while it wrote the folder has left beside it.
void removeRemains(const std::filesystem::path& folder);

}  // namespace candela::capture
