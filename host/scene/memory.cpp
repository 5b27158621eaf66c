// Computes the memory of a scene from the sizes of its arrays.
#include "host/scene/memory.h"

#include <nlohmann/json.hpp>

namespace candela::scene {
namespace {

template <class... Elements>
std::uint64_t bytesOf(const std::vector<Elements>&... arrays) {
  return (0 + ... + (arrays.size() * sizeof(Elements)));
}

std::uint64_t bytesOf(const Mesh& mesh) {
  return sizeof(Mesh) + bytesOf(mesh.positions, mesh.normals, mesh.texCoords[0], mesh.texCoords[1], mesh.tangents,
                                mesh.colours, mesh.indices);
}

std::uint64_t countTriangles(const Scene& scene) {
  std::uint64_t count = 0;
  for (const PrimitiveRun& run : scene.primitives.runs()) {
    if (run.start.kind == PrimitiveKind::triangle) count += scene.primitives.countOf(run);
  }
  return count;
}

}  // namespace

std::optional<double> SceneMemory::bytesPerTriangle() const {
  if (triangleCount == 0) return std::nullopt;
  return static_cast<double>(triangles) / static_cast<double>(triangleCount);
}

SceneMemory memoryOf(const Scene& scene) {
  SceneMemory memory;
  memory.triangleCount = countTriangles(scene);
  for (const Mesh& mesh : scene.meshes) memory.triangles += bytesOf(mesh);
  memory.triangles += bytesOf(scene.placements);
  memory.total = memory.triangles + scene.primitives.runs().size_bytes() +
                 bytesOf(scene.materials, scene.spheres, scene.boxes, scene.cones, scene.planes, scene.pointLights,
                         scene.punctualLights, scene.objectStarts, scene.objectNames, scene.materialNames);
  for (const TextureImage& image : scene.images) {
    memory.textures += sizeof(TextureImage) + bytesOf(image.texels, image.deepTexels);
    memory.deepTextures += bytesOf(image.deepTexels);
  }
  memory.total += memory.textures;
  if (scene.sky) {
    for (const SkyFace& face : scene.sky->faces) memory.total += face.rgb.size();
  }
  return memory;
}

nlohmann::ordered_json toJson(const SceneMemory& memory) {
  const std::optional<double> perTriangle = memory.bytesPerTriangle();
  return {{"sceneBytes", memory.total},
          {"bytesPerTriangle", perTriangle ? nlohmann::ordered_json(*perTriangle) : nlohmann::ordered_json()},
          {"textureBytes", memory.textures},
          {"deepTextureBytes", memory.deepTextures}};
}

}  // namespace candela::scene
