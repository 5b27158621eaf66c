// Reads scene files of every format that there is, each by its loader (host/formats/loading/loader.h).
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "host/formats/loading/load.h"
#include "host/formats/loading/loader.h"
#include "host/scene/environment/environment.h"

namespace candela::formats {

/// All loaders of the program. Formats that begin with a signature stand before those of plain text.
std::span<const scene::Loader> allLoaders();

/// A scene file of any format that is read once, whatever the number of moments at which its scene is made.
class SceneSource {
 public:
  /// The format is recognised by the file's content, or else by its extension. Throws SceneError with every error that
  /// was found, FileError if the file cannot be read or is larger than 1 GiB, and UsageError for definitions that are
  /// wrong, or if the format has no parameters.
  SceneSource(const std::filesystem::path& path, scene::LoadOptions options);
  SceneSource(const SceneSource&) = delete;
  SceneSource& operator=(const SceneSource&) = delete;
  ~SceneSource();

  /// Returns the scene that loadScene() returns with this time and orbit, which replace those of the options. Throws
  /// SceneError as that does.
  scene::LoadedScene at(std::optional<double> time, double orbit);

 private:
  std::string bytes_;
  scene::LoadOptions options_;
  std::unique_ptr<scene::SceneReader> reader_;
  std::optional<scene::LoadedScene> atRest_{};                 ///< once it was made
  std::optional<environment::ReadEnvironment> environment_{};  ///< once a scene was made
};

/// The scene of a file in memory, whose format is recognised by its content, or else by the extension of its name.
/// Throws SceneError with every error that was found, and UsageError for definitions as SceneSource does.
scene::LoadedScene loadScene(const scene::SceneFile& file, const scene::LoadOptions& options = {});

/// The format is recognised by the file's content, or else by its extension. Throws SceneError with every error that
/// was found, and FileError if the file cannot be read or is larger than 1 GiB. A file without a view loads:
/// Scene::camera is then empty, and the caller decides (scene::requireCamera).
scene::LoadedScene loadScene(const std::filesystem::path& path, const scene::LoadOptions& options = {});

}  // namespace candela::formats
