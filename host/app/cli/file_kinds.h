// Refuses names of files whose extension belongs to another format.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace candela::cli {

/// Returns whether the extension is that of a format in which scenes are read.
bool isSceneName(const std::filesystem::path& file);

/// Throws UsageError if `file` has an extension of a known format that is not one of `extensions`. The message suggests
/// the first of these. `what` is what is written, with the name of its format: "a film is an OpenEXR file".
void refuseOtherFormat(const std::filesystem::path& file, const std::vector<std::string_view>& extensions,
                       const std::string& what);

}  // namespace candela::cli
