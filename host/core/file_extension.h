// Extensions of file names.
#pragma once
#include <algorithm>
#include <filesystem>
#include <string>

namespace candela {

/// Returns the extension of a file with its dot, and ASCII letters in lower case, e.g. ".exr"; empty if there is none.
inline std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
  return extension;
}

}  // namespace candela
