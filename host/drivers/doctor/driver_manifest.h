// Reads the JSON file by which a Vulkan driver registers with the loader.
#pragma once
#include <filesystem>
#include <string>

namespace candela::doctor {

/// Source: the Vulkan loader's LoaderDriverInterface.md, "Driver Manifest File Format".
struct DriverManifest {
  std::filesystem::path file;
  std::string library;  ///< argument of dlopen(): a path, or the name of a library on the system's search path
  std::string problem;  ///< predicate of a sentence about the file, e.g. "does not exist"; empty: none
};

/// Never throws for any content of the file.
DriverManifest readManifest(const std::filesystem::path& file);

}  // namespace candela::doctor
