// A glTF 2.0 file in one piece: meshes, materials and images, with all data embedded.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace candela::generate {

/// A triangle mesh. `texCoords` is empty, or has one for each position, as `normals` do.
struct TriangleMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> texCoords;
  std::vector<std::uint32_t> indices;
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
  /// `angle` is the vertical field of view in degrees, `aspect` width / height.
  void addCamera(const glm::dvec3& from, const glm::dvec3& at, double angle, double aspect);

  /// Returns the file. `extensionsUsed` follows from the materials.
  std::string text() const;

 private:
  struct Shape {
    Json attributes;
    std::size_t indices;
  };

  /// Returns the index of the accessor.
  std::size_t addAccessor(const void* data, std::size_t bytes, const Json& accessor);

  Json root_;
  std::vector<Shape> shapes_;
  std::vector<std::byte> binary_;
};

}  // namespace candela::generate
