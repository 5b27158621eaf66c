// The film file of a render without --checkpoint whose device failed.
#pragma once
#include <filesystem>

#include "host/cli/arguments.h"

namespace candela::cli {

/// Returns the name of a file that does not exist yet, beside the first output: "picture.png.film.exr". Empty if there
/// is no output in a regular folder, or if too many such files exist.
std::filesystem::path rescueFile(const Arguments& arguments);

}  // namespace candela::cli
