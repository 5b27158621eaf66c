// Finds the drivers that the Vulkan loader finds.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "host/drivers/doctor/driver_manifest.h"

namespace candela::doctor {

/// Environment variables with patterns of the names of driver files that the loader uses or leaves out.
inline constexpr std::array kFilterVariables{"VK_LOADER_DRIVERS_SELECT", "VK_LOADER_DRIVERS_DISABLE"};

struct DriverFiles {
  std::string variable;  ///< environment variable that replaces the folders; empty: none
  /// Environment variable because of which the loader may find no driver: a list of files that is set, but empty, or a
  /// filter (VK_LOADER_DRIVERS_SELECT, VK_LOADER_DRIVERS_DISABLE). Empty: none.
  std::string hidingVariable;
  std::vector<std::filesystem::path> folders;
  std::vector<DriverManifest> manifests;
};

/// Reads VK_DRIVER_FILES, else VK_ICD_FILENAMES, else the folders of the XDG base directory specification, and then
/// VK_ADD_DRIVER_FILES. Source: LoaderDriverInterface.md of the Vulkan loader, "Driver Discovery on Linux".
DriverFiles findDriverFiles();

}  // namespace candela::doctor
