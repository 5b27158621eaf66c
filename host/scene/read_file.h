// Reads a whole file into memory.
#pragma once
#include <filesystem>
#include <string>

namespace candela::scene {

/// Returns the bytes of a scene file or of a file that belongs to it. Throws FileError, which names the file, if it
/// cannot be read or is larger than 1 GiB.
std::string readFile(const std::filesystem::path& path);

}  // namespace candela::scene
