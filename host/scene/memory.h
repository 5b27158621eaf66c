// The amount of memory that a scene occupies.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "host/scene/scene.h"

namespace candela::scene {

/// In bytes, for the elements in use: spare capacity of the arrays does not count.
struct SceneMemory {
  std::uint64_t total = 0;          ///< of all arrays of the scene, the sky's images included
  std::uint64_t triangles = 0;      ///< of these: the meshes, and the placements of their instances
  std::uint64_t triangleCount = 0;  ///< those of every instance count
  std::uint64_t textures = 0;       ///< of the total: the images of textures
  std::uint64_t deepTextures = 0;   ///< of these: the texels of 16 bits per channel

  /// Empty if there are no triangles.
  std::optional<double> bytesPerTriangle() const;
};

SceneMemory memoryOf(const Scene& scene);
/// Returns the member `memory` of JSON documents.
nlohmann::ordered_json toJson(const SceneMemory& memory);

}  // namespace candela::scene
