// Meshes of a file that are shown more than once: by several nodes, or by EXT_mesh_gpu_instancing.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "host/formats/gltf/value.h"
#include "host/scene/mesh.h"
#include "host/scene/texture.h"

namespace candela::gltf {

/// A mesh that is shown more than once, as far as the scene has it.
struct SharedMesh {
  std::size_t uses = 0;
  bool isRead = false;
  std::optional<std::uint32_t> mesh;      ///< index in Scene::meshes; nothing if there is nothing to render
  std::optional<std::uint32_t> mirrored;  ///< of the mesh for placements that mirror, once one was needed
  float minAlpha = 1;                     ///< of the vertex colours
  glm::dvec3 reach{0};                    ///< largest magnitudes of the coordinates
};

/// Returns a text that is equal for uses of a primitive that have the same vertices and triangles before nodes place
/// them: the primitive without its material, the weights of its morph targets, and the texture along which its tangents
/// run, on which they depend if the file does not state them.
std::string geometryKey(const Value& primitive, std::span<const double> weights,
                        const std::optional<scene::TextureReference>& tangentTexture);

/// Returns the mesh for placements that mirror: triangles have the other orientation, and tangents the other
/// handedness.
scene::Mesh mirroredMesh(scene::Mesh mesh);

/// Returns the largest magnitude of each coordinate of the vertices.
glm::dvec3 reachOf(const scene::Mesh& mesh);

/// Returns the smallest alpha of the vertex colours, and at most 1.
float minAlphaOf(const scene::Mesh& mesh);

}  // namespace candela::gltf
