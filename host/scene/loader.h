// The scene formats that can be read, and the choice among them.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/load.h"

namespace candela::scene {

/// A scene file in memory, text or binary. What it refers to must outlive it.
struct SceneFile {
  std::string_view bytes;
  std::string name;              ///< as the user gave it; messages begin with it
  std::filesystem::path folder;  ///< where the relative paths of the file start; not empty
};

/// Reads one family of formats.
struct Loader {
  std::string_view name;                     ///< as messages show it: "NFF or P3F"
  std::vector<std::string_view> extensions;  ///< in lower case with their dots: {".nff", ".p3f"}
  /// True if the bytes begin as this loader's formats do. The content decides before the extension does.
  bool (*recognises)(std::string_view bytes);
  /// Throws SceneError with every error that was found, each with its place: line and column in a text, the path of the
  /// element in the message otherwise. Other files are opened only where a PathGuard permits it. Scene::hash covers the
  /// bytes of the file and of all others that were read.
  LoadedScene (*load)(const SceneFile& file, const LoadOptions& options);
};

/// All loaders of the program. Formats that begin with a signature stand before those of plain text.
std::span<const Loader> allLoaders();

/// The first loader that recognises the bytes, or else the first that has the extension of `file` (in any case).
/// Throws SceneError, which names the formats that can be read, if there is none.
const Loader& chooseLoader(std::span<const Loader> loaders, const SceneFile& file);

}  // namespace candela::scene
