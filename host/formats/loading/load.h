// The options and the result of reading a scene. formats::loadScene() reads files of any format.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/formats/loading/diagnostic.h"
#include "host/scene/environment.h"
#include "host/scene/scene.h"

namespace candela::scene {

struct LoadOptions {
  bool lenient = false;  ///< warn of deviations that docs/scene-format.md, gltf.md and mesh-formats.md list
  std::vector<std::filesystem::path> allowedPaths{};  ///< folders, besides the scene's own, from which a scene may read
  std::optional<std::string> camera{};     ///< name or index of one of the file's cameras; "none": a view of everything
  std::optional<double> time{};            ///< seconds at which an animation is evaluated; empty: at rest
  std::optional<std::string> animation{};  ///< name or index of one of the file's animations; empty: the first
  std::vector<std::string> definitions{};  ///< "NAME=VALUE" each: values of the parameters of a Mitsuba scene
  double orbit = 0;  ///< degrees by which the camera is turned about its target, see formats::orbitedCamera()
  EnvironmentRequest environment{};  ///< replaces the background, and the default light

  bool hasEnvironment() const { return !environment.source.empty(); }
};

/// Number of statements of each kind in the file: "sphere", "polygon", "patch", "material", ...
using StatementCounts = std::map<std::string, std::uint64_t>;

/// Properties of a file that a loader reports besides the counts, in their order in the report: {"extensions",
/// "KHR_..."}.
using FileFacts = std::vector<std::pair<std::string, std::string>>;

struct LoadedScene {
  Scene scene;
  StatementCounts counts;
  std::vector<Diagnostic> warnings;
  FileFacts facts{};
  /// The files besides the scene's own that were read or tried: images, buffers, an environment, the folder of a sky.
  std::vector<std::filesystem::path> files{};
  /// Time of the last key frame of the animation in seconds; empty: the file has none.
  std::optional<double> animationEnd{};
};

/// The folder of a file, or "." where its path has none.
std::filesystem::path folderOrCurrent(const std::filesystem::path& folder);
/// Throws SceneError, with the syntax of a view, if the scene has no view.
void requireCamera(const Scene& scene);

}  // namespace candela::scene
