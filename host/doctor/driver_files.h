// Finds the drivers that the Vulkan loader finds.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "host/doctor/driver_manifest.h"

namespace candela::doctor {

struct DriverFiles {
  std::string variable;       ///< environment variable that replaces the folders; empty: none
  std::string emptyVariable;  ///< such a variable that is set, but empty: loaders may find no driver; empty: none
  std::vector<std::filesystem::path> folders;
  std::vector<DriverManifest> manifests;
};

/// Reads VK_DRIVER_FILES, else VK_ICD_FILENAMES, else the folders of the XDG base directory specification, and then
/// VK_ADD_DRIVER_FILES. Source: LoaderDriverInterface.md of the Vulkan loader, "Driver Discovery on Linux".
DriverFiles findDriverFiles();

}  // namespace candela::doctor
