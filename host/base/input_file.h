// Reads whole files that the user or a scene names.
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace candela {

enum class InputKind {
  regularFile,       ///< for names that come from a file
  regularFileOrPipe  ///< for names from the command line, which may be <(...) of a shell
};

/// Returns the content of a file of at most `maxBytes`. Throws FileError, which names the file: it cannot be read, is
/// larger, or is not of this kind, such as a folder or a device. It never blocks forever: a pipe that no program opens
/// for writing within ten seconds, or whose writer is silent for ten seconds, is an error.
std::string readInputFile(const std::filesystem::path& file, std::size_t maxBytes, InputKind kind);

}  // namespace candela
