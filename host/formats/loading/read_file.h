// Reads a whole file into memory.
#pragma once
#include <filesystem>
#include <string>

#include "host/base/input_file.h"

namespace candela::scene {

/// Returns the bytes of a scene file or of a file that belongs to it. Throws FileError as readInputFile() does; the
/// maximum size is 1 GiB.
std::string readFile(const std::filesystem::path& path, InputKind kind = InputKind::regularFile);

}  // namespace candela::scene
