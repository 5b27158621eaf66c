// Resolves paths and compares them with the permitted folders.
#include "host/formats/loading/path_guard.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/quote.h"
#include "host/base/setting_words.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

/// Returns the absolute path without links and dots; the part that does not exist stays as written. Empty on failure.
fs::path resolve(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return {};
  const fs::path resolved = fs::weakly_canonical(absolute, error);
  if (error) return {};
  return resolved.filename().empty() ? resolved.parent_path() : resolved;  // without a trailing slash
}

bool liesIn(const fs::path& path, const fs::path& folder) {
  if (path.empty() || folder.empty()) return false;
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace

PathGuard::PathGuard(const fs::path& sceneFolder, const std::vector<fs::path>& allowedFolders) {
  folders_.push_back(resolve(sceneFolder));
  for (const fs::path& folder : allowedFolders) folders_.push_back(resolve(folder));
}

bool PathGuard::permits(const fs::path& path) const {
  const fs::path resolved = resolve(path);
  return std::ranges::any_of(folders_, [&](const fs::path& folder) { return liesIn(resolved, folder); });
}

void PathGuard::require(const fs::path& path) {
  if (!permits(path)) {
    throw FileError(fmt::format("{} is outside the scene's folder; {} permits it", quote(path.string()),
                                settingWords("allow-path", "DIR")));
  }
  required_.push_back(path);
}

}  // namespace candela::scene
