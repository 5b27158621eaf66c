// Extensions of file names.
#pragma once
#include <filesystem>
#include <string>

#include "host/base/lower_case.h"

namespace candela {

/// Returns the extension of a file with its dot, and ASCII letters in lower case, e.g. ".exr"; empty if there is none.
inline std::string extensionOf(const std::filesystem::path& file) { return lowerCase(file.extension().string()); }

}  // namespace candela
