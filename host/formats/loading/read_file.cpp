// Reads a whole file into memory.
#include "host/formats/loading/read_file.h"

namespace candela::scene {

std::string readFile(const std::filesystem::path& path, InputKind kind) {
  constexpr std::size_t kMaxFileSize = std::size_t{1} << 30;
  return readInputFile(path, kMaxFileSize, kind);
}

}  // namespace candela::scene
