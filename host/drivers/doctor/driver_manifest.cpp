// Reads the JSON file by which a Vulkan driver registers with the loader.
#include "host/drivers/doctor/driver_manifest.h"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/base/json_text.h"
#include "host/job/cache/read_file.h"

namespace candela::doctor {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

// A library with a folder in its name is relative to the folder of the file, as for the loader.
std::string libraryOf(const std::filesystem::path& file, const std::string& name) {
  const std::filesystem::path library = name;
  return library.is_absolute() || !library.has_parent_path() ? name : (file.parent_path() / library).string();
}

void interpret(const Json& json, DriverManifest& manifest) {
  const Json* const icd = json.is_object() && json.contains("ICD") ? &json["ICD"] : nullptr;
  if (icd == nullptr || !icd->is_object()) {
    manifest.problem = "has no object \"ICD\"";
  } else if (!icd->contains("library_path") || !(*icd)["library_path"].is_string()) {
    manifest.problem = "has no string \"library_path\" in \"ICD\"";
  } else {
    manifest.library = libraryOf(manifest.file, (*icd)["library_path"].get<std::string>());
  }
}

}  // namespace

DriverManifest readManifest(const std::filesystem::path& file) {
  DriverManifest manifest{file, "", ""};
  const std::optional<std::string> text = cache::readRegularFile(file, kMaxBytes, manifest.problem);
  if (!text) {
    manifest.problem = manifest.problem.empty() ? "does not exist" : "cannot be read: " + manifest.problem;
    return manifest;
  }
  try {
    interpret(parseJson(*text), manifest);
  } catch (const JsonSyntaxError& error) {
    manifest.problem = fmt::format("has an error at line {}, column {}: {}", error.line, error.column, error.what());
  }
  return manifest;
}

}  // namespace candela::doctor
