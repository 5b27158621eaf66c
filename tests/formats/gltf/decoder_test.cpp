// Data compressed by Draco and meshoptimizer: encoded here, decoded by the loader.
#include "host/formats/gltf/draco.h"
#include "host/formats/gltf/meshopt.h"
#include "tests/formats/gltf/gltf_file.h"

#if __has_include(<draco/compression/encode.h>) && __has_include(<meshoptimizer.h>)
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

namespace candela::gltf {
namespace {

const std::vector<float> kCorners{0, 0, 0, 1, 0, 0, 0, 1, 0};

std::vector<char> encoded(const draco::Mesh& mesh) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

std::vector<char> dracoTriangle() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), &kCorners[0], &kCorners[3], &kCorners[6]);
  return encoded(*builder.Finalize());
}

/// The triangle with colours of unsigned bytes, alpha 255, with or without Draco's own flag of normalised integers.
std::vector<char> colouredDracoTriangle(bool flag) {
  const std::vector<std::uint8_t> colours{51, 0, 255, 255, 102, 0, 255, 255, 153, 0, 255, 255};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int colour = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
  builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), &kCorners[0], &kCorners[3], &kCorners[6]);
  builder.SetAttributeValuesForFace(colour, draco::FaceIndex(0), &colours[0], &colours[4], &colours[8]);
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  mesh->attribute(colour)->set_normalized(flag);
  return encoded(*mesh);
}

GltfFile dracoFile(const std::vector<char>& compressed) {
  GltfFile file;
  const std::size_t view = file.view(compressed);
  file.root["accessors"] = {{{"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}}};
  json primitive{{"attributes", {{"POSITION", 0}}}};
  primitive["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  file.addMesh(primitive);
  file.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return file;
}

/// A file whose buffer view 0 is compressed.
GltfFile meshoptFile() {
  std::vector<unsigned char> compressed(meshopt_encodeVertexBufferBound(3, 12));
  compressed.resize(meshopt_encodeVertexBuffer(compressed.data(), compressed.size(), kCorners.data(), 3, 12));
  GltfFile file;
  file.view(compressed);
  json& view = file.root["bufferViews"][0];
  view["extensions"]["EXT_meshopt_compression"] = {
      {"buffer", 0}, {"byteLength", compressed.size()}, {"byteStride", 12}, {"count", 3}, {"mode", "ATTRIBUTES"}};
  view["byteLength"] = 36;
  view["buffer"] = 1;  // without data: only for those that cannot decode
  file.root["accessors"] = {{{"bufferView", 0}, {"componentType", kFloat}, {"count", 3}, {"type", "VEC3"}}};
  file.addMesh({{"attributes", {{"POSITION", 0}}}});
  file.root["extensionsRequired"] = {"EXT_meshopt_compression"};
  return file;
}

}  // namespace

TEST_CASE("a primitive compressed by Draco has its triangles") {
  if (!canDecodeDraco()) return;
  const scene::Scene scene = sceneOf(dracoFile(dracoTriangle()));
  REQUIRE(scene.primitives.size() == 1);
  const scene::Triangle triangle = triangleOf(scene, scene.primitives[0]);
  CHECK(glm::cross(triangle.p[1] - triangle.p[0], triangle.p[2] - triangle.p[0]) == glm::vec3(0, 0, 1));
}

TEST_CASE("the accessor says whether integers in Draco data are normalised, whatever the flag in the data says") {
  if (!canDecodeDraco()) return;
  for (const bool flag : {false, true}) {
    CAPTURE(flag);
    GltfFile file = dracoFile(colouredDracoTriangle(flag));
    json& primitive = file.primitive();
    primitive["attributes"]["COLOR_0"] = 1;
    primitive["extensions"]["KHR_draco_mesh_compression"]["attributes"]["COLOR_0"] = 1;
    file.root["accessors"].push_back(
        {{"componentType", kUnsignedByte}, {"count", 3}, {"type", "VEC4"}, {"normalized", true}});
    std::vector<glm::vec4> colours = sceneOf(file).meshes.at(0).colours;
    std::ranges::sort(colours, {}, [](const glm::vec4& colour) { return colour.x; });
    REQUIRE(colours.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(colours[i] == glm::vec4(static_cast<float>(51 * (i + 1)) / 255, 0, 1, 1));
    }
  }
}

TEST_CASE("positions in Draco data are normalised as the accessor says") {
  if (!canDecodeDraco()) return;
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(1);
  const std::vector<std::int16_t> corners{0, 0, 0, 32767, 0, 0, 0, -32768, 0};
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_INT16);
  builder.SetAttributeValuesForFace(position, draco::FaceIndex(0), &corners[0], &corners[3], &corners[6]);
  GltfFile file = dracoFile(encoded(*builder.Finalize()));
  file.root["accessors"][0]["componentType"] = kShort;
  const auto extent = [&] {
    const std::vector<glm::vec3> positions = sceneOf(file).meshes.at(0).positions;
    glm::vec3 sum(0);
    for (const glm::vec3& p : positions) sum += p;
    return sum;
  };
  CHECK(extent() == glm::vec3(32767, -32768, 0));
  file.root["accessors"][0]["normalized"] = true;
  CHECK(extent() == glm::vec3(1, -1, 0));
}

TEST_CASE("damaged Draco data is an error with its place") {
  if (!canDecodeDraco()) return;
  std::vector<char> cut = dracoTriangle();
  cut.resize(cut.size() / 2);
  const std::string place = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
  CHECK(errorsOf(dracoFile(cut).text()).find(place + ": the compressed data is damaged") != std::string::npos);
  GltfFile other = dracoFile(dracoTriangle());
  other.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 7;
  CHECK(errorsOf(other.text()).find(place + "/attributes/POSITION: the compressed data has no such") !=
        std::string::npos);
}

TEST_CASE("a view compressed by meshoptimizer is decoded") {
  if (!canDecodeMeshopt()) return;
  CHECK(sceneOf(meshoptFile()).meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

TEST_CASE("KHR_meshopt_compression is decoded where it equals the older extension, else refused with the reason") {
  if (!canDecodeMeshopt()) return;
  GltfFile file = meshoptFile();
  const json compression = file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  json& renamed = file.root["bufferViews"][0]["extensions"];
  renamed = {{"KHR_meshopt_compression", compression}};
  file.root["extensionsRequired"] = {"KHR_meshopt_compression"};
  CHECK(sceneOf(file).meshes.at(0).positions[2] == glm::vec3(0, 1, 0));
  const std::string place = "/bufferViews/0/extensions/KHR_meshopt_compression";
  SECTION("its filter") {
    renamed["KHR_meshopt_compression"]["filter"] = "COLOR";
    CHECK(errorsOf(file.text()).find(place + "/filter: \"COLOR\" is not NONE") != std::string::npos);
  }
  SECTION("its version of the stream") {
    file.binary[0] = static_cast<char>(0xa1);
    CHECK(errorsOf(file.text()).find(place + ": attributes in version 1") != std::string::npos);
  }
}

TEST_CASE("data that would crash meshoptimizer is refused first") {
  if (!canDecodeMeshopt()) return;
  const std::string place = "/bufferViews/0/extensions/EXT_meshopt_compression";
  const std::vector<std::tuple<const char*, json, std::string>> changes{
      {"byteStride", 6, "/byteStride: 6 does not fit mode"},
      {"byteStride", 260, "/byteStride: 260 does not fit"},
      {"count", 1u << 31, "/count: 2147483648 elements cannot be in"},
      {"mode", "POINTS", "/mode: \"POINTS\" is not"},
      {"mode", "TRIANGLES", "/byteStride: 12 does not fit mode"},
      {"filter", "OCTAHEDRAL", "/byteStride: 12 does not fit"},
      {"filter", "SHARPEN", "/filter: \"SHARPEN\" is not NONE"},
      {"byteLength", 9, ": the compressed data is damaged"},
      {"byteLength", 1u << 31, ": bytes 0 to 2147483648 of a buffer of"}};
  for (const auto& [key, value, message] : changes) {
    CAPTURE(message);
    GltfFile file = meshoptFile();
    file.root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"][key] = value;
    CHECK(errorsOf(file.text()).find(place + message) != std::string::npos);
  }
}

}  // namespace candela::gltf
#endif
