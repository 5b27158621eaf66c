// The interface of the loaders of scene formats, and the choice among several. host/formats has the list of all.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/loading/load.h"

namespace candela::scene {

/// A scene file in memory, text or binary. The data to which it refers must outlive it.
struct SceneFile {
  std::string_view bytes;
  std::string name;              ///< as the user gave it; messages begin with it
  std::filesystem::path folder;  ///< base of the relative paths in the file; not empty
};

/// A scene file that has been read, and from which the scene is made for any moment of its animation.
class SceneReader {
 public:
  virtual ~SceneReader() = default;
  /// Returns the scene at a time, see LoadOptions::time: the same as if the file were read for it alone. Throws
  /// SceneError with every error that was found, each with its position: line and column in a text, otherwise the path
  /// of the element in the message. Other files are opened only if a PathGuard permits it, and are listed in
  /// LoadedScene::files. Scene::hash covers the bytes of the file and of all others that were read.
  virtual LoadedScene at(std::optional<double> time) = 0;
};

/// Returns a reader of a file that looks the same at all times: `load` reads it with LoadOptions::time set.
std::unique_ptr<SceneReader> readStill(const SceneFile& file, const LoadOptions& options,
                                       LoadedScene (*load)(const SceneFile&, const LoadOptions&));

/// Reads one family of formats.
struct Loader {
  std::string_view name;                     ///< as messages show it: "NFF or P3F"
  std::vector<std::string_view> extensions;  ///< in lower case with their dots: {".nff", ".p3f"}
  /// Returns true if the bytes begin as this loader's formats do. The content takes precedence over the extension.
  bool (*recognises)(std::string_view bytes);
  /// Returns a reader, which ignores LoadOptions::time. The bytes of the file must outlive it. Throws as
  /// SceneReader::at() does. If `isOften`, at() is called for several moments: the reader keeps what they share.
  std::unique_ptr<SceneReader> (*open)(const SceneFile& file, const LoadOptions& options, bool isOften);
  bool hasParameters = false;  ///< that LoadOptions::definitions set
};

/// Returns the first loader that recognises the bytes, else the first that has the extension of `file` (in any case).
/// Throws SceneError, which names the formats that can be read, if there is none.
const Loader& chooseLoader(std::span<const Loader> loaders, const SceneFile& file);

}  // namespace candela::scene
