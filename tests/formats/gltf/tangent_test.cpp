// Normal maps, and the tangents that they need: those of the file, or computed.
#include "host/image/codecs.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

// Two triangles with one vertex in common, whose images are mirrored to each other. The material has a normal map.
GltfFile mappedFile() {
  GltfFile file;
  file.root["images"] = {{{"bufferView", file.view(image::toPng({1, 1, {128, 128, 255}}))}, {"mimeType", "image/png"}}};
  file.root["textures"] = {{{"source", 0}}};
  file.root["materials"] = {{{"normalTexture", {{"index", 0}, {"scale", 0.5}}}}};
  const std::size_t positions = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0});
  const std::size_t coords = file.vectors({0, 0, 1, 0, 0, -1, 1, 0}, "VEC2", 2);
  const std::size_t normals = file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", 3);
  const std::size_t indices = file.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, kUnsignedShort, "SCALAR", 6);
  file.addMesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", coords}, {"NORMAL", normals}}},
                {"indices", indices},
                {"material", 0}});
  return file;
}

}  // namespace

TEST_CASE("a normal map has a scale, whose default is 1") {
  GltfFile file = mappedFile();
  CHECK(textureOf(sceneOf(file).materials[0], scene::TextureSlot::normal).has_value());
  CHECK(sceneOf(file).materials[0].normalScale == 0.5f);
  CHECK_FALSE(warns(load(file), "normal"));
  file.root["materials"][0]["normalTexture"].erase("scale");
  CHECK(sceneOf(file).materials[0].normalScale == 1);
}

TEST_CASE("vertices whose triangles have different tangents are split") {
  const scene::Scene scene = sceneOf(mappedFile());
  const scene::Mesh& mesh = scene.meshes.at(0);
  REQUIRE(mesh.positions.size() == 6);
  REQUIRE(mesh.tangents.size() == 6);
  const auto right = attributeOf(mesh, mesh.tangents, 0);
  const auto left = attributeOf(mesh, mesh.tangents, 1);
  for (std::uint32_t k = 0; k < 3; ++k) {
    CHECK(right[k] == glm::vec4(1, 0, 0, 1));
    CHECK(left[k] == glm::vec4(-1, 0, 0, -1));
  }
  CHECK(attributeOf(mesh, mesh.positions, 1) == std::array<glm::vec3, 3>{{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}});
  CHECK(attributeOf(mesh, mesh.texCoords[0], 1) == std::array<glm::vec2, 3>{{{0, 0}, {0, -1}, {1, 0}}});
  CHECK(attributeOf(mesh, mesh.normals, 1)[2] == glm::vec3(0, 0, 1));
}

TEST_CASE("vertices of meshes without normals have the tangents of flat triangles") {
  GltfFile file = mappedFile();
  file.primitive()["attributes"].erase("NORMAL");
  CHECK(sceneOf(file).meshes.at(0).tangents.size() == 6);
}

TEST_CASE("computed tangents are placed with their node") {
  GltfFile file = mappedFile();
  file.root["nodes"][0]["scale"] = {-2, 1, 1};
  const scene::Scene scene = sceneOf(file);
  const scene::Mesh& mesh = scene.meshes.at(0);
  CHECK(mesh.tangents[vertexIndex(mesh, 0, 0)] == glm::vec4(-1, 0, 0, -1));
}

TEST_CASE("tangents of the file are not replaced, and materials without a normal map need none") {
  GltfFile file = mappedFile();
  file.primitive()["attributes"]["TANGENT"] = file.vectors({0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", 4);
  CHECK(sceneOf(file).meshes.at(0).tangents == std::vector<glm::vec4>(4, {0, 1, 0, 1}));
  file.primitive()["attributes"].erase("TANGENT");
  file.root["materials"][0].erase("normalTexture");
  CHECK(sceneOf(file).meshes.at(0).tangents.empty());
}

}  // namespace candela::gltf
