// Applies the loader's rules of driver discovery on Linux.
#include "host/drivers/doctor/driver_files.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <system_error>

#include "host/base/environment.h"

namespace candela::doctor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> splitList(const std::string& list) {
  std::vector<fs::path> paths;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ':');) {
    if (!word.empty()) paths.emplace_back(word);
  }
  return paths;
}

// A user's own folder comes first, then the list of the system's, each from its variable or its default.
void addFolders(std::vector<fs::path>& folders, const char* userVariable, const char* userDefault,
                const char* systemVariable, const char* systemDefault) {
  const auto add = [&](const fs::path& base) {
    const fs::path folder = base / "vulkan" / "icd.d";
    if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
  };
  const std::string user = environmentVariable(userVariable);
  const std::string home = environmentVariable("HOME");
  if (!user.empty()) {
    add(user);
  } else if (!home.empty()) {
    add(fs::path(home) / userDefault);
  }
  const std::string system = environmentVariable(systemVariable);
  for (const fs::path& base : splitList(system.empty() ? systemDefault : system)) add(base);
}

std::vector<fs::path> searchedFolders() {
  std::vector<fs::path> folders;
  addFolders(folders, "XDG_CONFIG_HOME", ".config", "XDG_CONFIG_DIRS", "/etc/xdg");
  for (const char* folder : {"/usr/local/etc/vulkan/icd.d", "/etc/vulkan/icd.d"}) folders.emplace_back(folder);
  addFolders(folders, "XDG_DATA_HOME", ".local/share", "XDG_DATA_DIRS", "/usr/local/share:/usr/share");
  return folders;
}

void addFolder(const fs::path& folder, std::vector<DriverManifest>& manifests) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".json") files.push_back(entry->path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) manifests.push_back(readManifest(file));
}

// The variables list files, and folders of files.
void addList(const std::string& list, std::vector<DriverManifest>& manifests) {
  for (const fs::path& path : splitList(list)) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      addFolder(path, manifests);
    } else {
      manifests.push_back(readManifest(path));
    }
  }
}

}  // namespace

DriverFiles findDriverFiles() {
  DriverFiles found;
  for (const char* name : kFilterVariables) {
    if (!environmentVariable(name).empty()) found.hidingVariable = name;
  }
  for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
    const bool isSet = std::getenv(name) != nullptr;
    if (found.variable.empty() && isSet && environmentVariable(name).empty()) found.hidingVariable = name;
    if (found.variable.empty() && !environmentVariable(name).empty()) found.variable = name;
  }
  if (!found.variable.empty()) {
    addList(environmentVariable(found.variable.c_str()), found.manifests);
    return found;
  }
  found.folders = searchedFolders();
  for (const fs::path& folder : found.folders) addFolder(folder, found.manifests);
  addList(environmentVariable("VK_ADD_DRIVER_FILES"), found.manifests);
  return found;
}

}  // namespace candela::doctor
