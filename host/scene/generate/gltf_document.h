// A glTF 2.0 file in one piece: meshes, materials and images, with all data embedded.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace candela::generate {

/// A triangle mesh. `texCoords` and `colours` are empty, or have one for each position, as `normals` do.
struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> texCoords;
  std::vector<std::uint32_t> indices;
  std::vector<glm::vec3> colours{};  ///< they scale the base colour of the material

  std::uint64_t triangleCount() const { return indices.size() / 3; }
};

/// A shape with its material, as addShape() and addMaterial() number them.
struct MeshPart {
  std::size_t shape;
  std::size_t material;
};

/// A place of a mesh that is shown many times: scaled, turned about the vertical and moved.
struct MeshInstance {
  glm::dvec3 translation;
  double turn = 0;  ///< counter-clockwise, seen from above, in radians
  glm::dvec3 scale{1};
};

/// Numbers are those of the glTF specification. Materials are its JSON objects.
class GltfDocument {
 public:
  using Json = nlohmann::ordered_json;

  GltfDocument();

  /// Returns the index of the shape, for addNode().
  std::size_t addShape(const TriangleMesh& mesh);
  std::size_t addMaterial(const Json& material);
  /// Adds an image of 8-bit sRGB pixels, three bytes each, row by row from the top, and returns the index of a texture
  /// that repeats it.
  std::size_t addTexture(std::uint32_t width, std::uint32_t height, const std::vector<std::byte>& rgb);
  /// Adds a node that shows the shape with the material at a place.
  void addNode(std::size_t shape, std::size_t material, const glm::dvec3& translation);
  /// Adds a mesh of several parts and returns its index, for addInstances().
  std::size_t addMesh(std::span<const MeshPart> parts);
  /// Adds a node that shows the mesh at all places, by EXT_mesh_gpu_instancing. Without places, it adds nothing.
  void addInstances(std::size_t mesh, std::span<const MeshInstance> places);
  /// `angle` is the vertical field of view in degrees, `aspect` width / height.
  void addCamera(const glm::dvec3& from, const glm::dvec3& at, double angle, double aspect);

  /// Returns the file. `extensionsUsed` follows from materials and instances.
  std::string text() const;

 private:
  struct Shape {
    Json attributes;
    std::size_t indices;
  };

  /// Returns the index of the accessor.
  std::size_t addAccessor(const void* data, std::size_t bytes, const Json& accessor);

  /// Returns the index of an accessor of numbers in single precision.
  template <class Vector>
  std::size_t addFloats(const std::vector<Vector>& values, const char* type);
  /// Adds a node to the scene.
  void addToScene(Json node);

  Json root_;
  bool hasInstances_ = false;
  std::vector<Shape> shapes_;
  std::vector<std::byte> binary_;
};

}  // namespace candela::generate
