// Makes the environment of a scene from the options --env, --env-rotate and --env-scale.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/environment.h"

namespace candela::environment {

/// Maximum number of texels of a map.
inline constexpr std::uint64_t kMaxTexels = std::uint64_t{1} << 25;

struct ReadEnvironment {
  scene::Environment environment;
  std::vector<std::string> warnings{};  ///< about the file
};

/// Reads an image file (equirectangular, of any size up to kMaxTexels; an EXR file covers its display window, and is
/// black where it has no pixels), or computes the map of "white" (radiance 1) or of "sun:..." (docs/gltf.md). `up` is
/// the axis of the scene that points up: one of the six unit vectors along a coordinate axis. Throws UsageError for
/// numbers of "sun:" out of range, FileError for a file that cannot be read, is too large, is a cube map, or has
/// radiances that are not finite after scaling. If `isLenient`, pixels of the file that are not finite become black,
/// with a warning. Negative radiances become 0.
ReadEnvironment readEnvironment(const scene::EnvironmentRequest& request, const glm::vec3& up, bool isLenient);
/// Returns what readEnvironment() reads if it is not lenient.
scene::Environment makeEnvironment(const scene::EnvironmentRequest& request, const glm::vec3& up);

/// Returns whether the source of an environment is the path of an image file, neither "white" nor "sun:...".
bool isImageFile(std::string_view source);

/// Continues `hash` over everything of an environment that light depends on.
std::uint64_t hashOf(const scene::Environment& environment, std::uint64_t hash);

}  // namespace candela::environment
