// Examines memory and disk space.
#pragma once
#include <filesystem>
#include <string>

#include "host/drivers/doctor/check.h"

namespace candela::doctor {

/// Returns why no file can be created in `folder`, which need not exist, or an empty text. Creates nothing.
std::string whyNotWritable(const std::filesystem::path& folder);

/// Examines the memory of the machine, and the disk of `folder`, into which pictures are written. Empty: the working
/// folder, which was removed.
Checks checkResources(const std::filesystem::path& folder);

}  // namespace candela::doctor
