// The folders from which a scene may read files.
#pragma once
#include <filesystem>
#include <vector>

namespace candela::scene {

/// Permits the files in the scene's own folder and in the folders that `--allow-path` names. Every loader must query it
/// before it opens a file that a scene names: a sky box, a buffer, a texture.
class PathGuard {
 public:
  PathGuard(const std::filesystem::path& sceneFolder, const std::vector<std::filesystem::path>& allowedFolders);

  /// Returns whether `path` is in one of the folders, or is one of them, after all links and dots are resolved. A path
  /// that does not exist is judged by the part of it that exists.
  bool permits(const std::filesystem::path& path) const;
  /// Throws FileError unless permits(path). The path is then one of requiredPaths().
  void require(const std::filesystem::path& path);
  /// Returns the paths that were passed to require() and are permitted: the files, and folders, that the scene reads.
  const std::vector<std::filesystem::path>& requiredPaths() const { return required_; }

 private:
  std::vector<std::filesystem::path> folders_;  ///< resolved
  std::vector<std::filesystem::path> required_;
};

}  // namespace candela::scene
