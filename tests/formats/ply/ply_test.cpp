// PLY: every property that is rendered, with exact values, in every encoding.
#include "host/formats/load_scene.h"
#include "host/image/codecs.h"
#include "host/image/colour_transfer.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/ply/ply_file.h"

namespace candela::ply {
namespace {

using Indices = std::vector<std::uint32_t>;

/// A triangle whose coordinates have the type `Number`, in a binary file.
template <class Number, class Count, class Index>
std::string binaryTriangle(const std::string& type, const std::string& countType, const std::string& indexType,
                           bool isBigEndian) {
  std::string bytes = header("element vertex 3\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
                                 " z\nelement face 1\nproperty list " + countType + " " + indexType + " vertex_index\n",
                             isBigEndian ? "binary_big_endian" : "binary_little_endian");
  for (const int number : {1, 2, 3, 4, 2, 3, 1, 5, 3}) bytes += bytesOf(static_cast<Number>(number), isBigEndian);
  bytes += bytesOf(static_cast<Count>(3), isBigEndian);
  for (const int index : {2, 0, 1}) bytes += bytesOf(static_cast<Index>(index), isBigEndian);
  return bytes;
}

void checkBinaryTriangle(const std::string& bytes) {
  const scene::Mesh mesh = meshOf(bytes);
  CHECK(mesh.positions == std::vector<glm::vec3>{{1, 2, 3}, {4, 2, 3}, {1, 5, 3}});
  CHECK(mesh.indices == Indices{2, 0, 1});
}

std::string squareWith(const std::string& element, const std::string& rows) {
  return header("element vertex 4\n" + kPositions + element) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + rows;
}

}  // namespace

TEST_CASE("PLY in ASCII has the coordinates of its decimals, rounded once") {
  const scene::Mesh mesh = meshOf(
      header("element vertex 3\nproperty double x\nproperty float y\nproperty float32 z\n" + kFaces) +
      "0.1 +.5 -1e-3\n1.00000017881393432617187499 1e-60 3\n\t16777217  2\n-0\n3 0 1 2\n");
  // The second x is below the middle between two floats and rounds to the smaller; through a double it would not.
  CHECK(mesh.positions ==
        std::vector<glm::vec3>{{0.1f, 0.5f, -1e-3f}, {1.00000011920928955078125f, 0, 3}, {16777216, 2, -0.0f}});
  CHECK(mesh.indices == Indices{0, 1, 2});
  CHECK(mesh.normals.empty());
  CHECK(mesh.colours.empty());
}

TEST_CASE("PLY in binary has every type of number in both orders of bytes") {
  const bool isBigEndian = GENERATE(false, true);
  checkBinaryTriangle(binaryTriangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", isBigEndian));
  checkBinaryTriangle(binaryTriangle<double, std::int8_t, std::uint32_t>("double", "char", "uint", isBigEndian));
  checkBinaryTriangle(
      binaryTriangle<std::int8_t, std::uint16_t, std::uint16_t>("char", "ushort", "ushort", isBigEndian));
  checkBinaryTriangle(binaryTriangle<std::uint8_t, std::int16_t, std::int16_t>("uint8", "int16", "int16", isBigEndian));
  checkBinaryTriangle(binaryTriangle<std::int16_t, std::int32_t, std::uint8_t>("short", "int32", "uint8", isBigEndian));
  checkBinaryTriangle(
      binaryTriangle<std::uint16_t, std::uint32_t, std::int8_t>("uint16", "uint32", "int8", isBigEndian));
  checkBinaryTriangle(binaryTriangle<std::int32_t, std::uint8_t, float>("int", "uint8", "float32", isBigEndian));
  checkBinaryTriangle(binaryTriangle<std::uint32_t, std::uint8_t, double>("uint32", "uchar", "float64", isBigEndian));
}

TEST_CASE("A PLY in ASCII and one in binary give the same mesh") {
  const std::string text = header("element vertex 3\n" + kPositions + kFaces) + "1 2 3\n4 2 3\n1 5 3\n3 2 0 1\n";
  CHECK(meshOf(text) == meshOf(binaryTriangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", true)));
}

TEST_CASE("Lines of a PLY may end with CR LF or with CR") {
  const std::string text = triangle("", {"", "", ""});
  for (const char* const lineEnd : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? std::string(lineEnd) : std::string(1, c);
    CHECK(meshOf(other) == meshOf(text));
  }
  const std::string crLf =
      "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 3\r\nproperty uchar x\r\n"
      "property uchar y\r\nproperty uchar z\r\nelement face 1\r\nproperty list uchar uchar "
      "vertex_indices\r\nend_header\r\n";
  CHECK(meshOf(crLf + std::string("\n\r\1\1\2\3\3\1\1\3\0\1\2", 13)).positions[0] == glm::vec3(10, 13, 1));
  std::string mixed = triangle("", {"", "", ""});
  mixed.replace(mixed.find("end_header\n"), 11, "end_header\r\n");
  CHECK(meshOf(mixed) == meshOf(text));
}

TEST_CASE("Polygons of a PLY are triangulated, faces of fewer vertices left out") {
  CHECK(meshOf(squareWith(kFaces, "4 0 1 2 3\n")).indices == Indices{3, 0, 1, 3, 1, 2});
  // A dart whose reflex vertex is 3: a fan from 0 would leave the polygon.
  const std::string dart = header("element vertex 4\n" + kPositions + kFaces) +
                           "0 0 0\n2 1 0\n0 2 0\n1 1 0\n4 0 1 2 3\n";
  CHECK(meshOf(dart).indices == Indices{3, 0, 1, 3, 1, 2});
  const scene::LoadedScene small = load(
      squareWith("element face 3\nproperty list uchar int vertex_indices\n", "2 0 1\n3 0 1 2\n0\n"));
  CHECK(small.scene.meshes[0].indices == Indices{0, 1, 2});
  CHECK(warningsOf(small) == std::vector<std::string>{"test.ply:14:5: a face of fewer than three vertices is not "
                                                      "rendered (and 1 more like it)"});
}

TEST_CASE("Strips of a PLY turn every second triangle") {
  const scene::LoadedScene strips = load(
      squareWith("element tristrips 1\nproperty list int int vertex_indices\n", "9 0 1 3 2 -1 1 2 2 3\n"));
  CHECK(strips.scene.meshes[0].indices == Indices{0, 1, 3, 3, 1, 2});
  CHECK(strips.counts == scene::StatementCounts{{"strip", 1}, {"vertex", 4}});
}

TEST_CASE("Faces of a PLY may stand before its vertices") {
  const std::string text = header(kFaces + "element vertex 4\n" + kPositions) +
                           "4 0 1 2 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  CHECK(meshOf(text).indices == Indices{3, 0, 1, 3, 1, 2});
}

TEST_CASE("Normals of a PLY get unit length, and those that are none are replaced") {
  const scene::Mesh mesh = meshOf(
      triangle("property float nx\nproperty float ny\nproperty float nz\n", {"0 0 5", "nan 0 0", "0 -3 4"}));
  CHECK(mesh.normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, -0.6f, 0.8f}});
  CHECK(meshOf(triangle("property float nx\nproperty float ny\n", {"0 0", "0 0", "0 0"})).normals.empty());
}

TEST_CASE("Colours of a PLY are decoded from sRGB, by the range of their type") {
  const auto decode = [](double signal) { return static_cast<float>(image::srgbDecode(signal)); };
  const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  CHECK(meshOf(triangle(bytes, {"255 0 51", "0 0 0", "0 0 0"})).colours[0] == glm::vec4(1, 0, decode(0.2), 1));
  const std::string shorts = "property ushort r\nproperty ushort g\nproperty ushort b\n";
  CHECK(meshOf(triangle(shorts, {"65535 0 13107", "0 0 0", "0 0 0"})).colours[0] == glm::vec4(1, 0, decode(0.2), 1));
  const std::string floats = "property float diffuse_red\nproperty float diffuse_green\nproperty float diffuse_blue\n";
  CHECK(meshOf(triangle(floats, {"1.5 -1 0.5", "0 0 0", "0 0 0"})).colours[0] == glm::vec4(1, 0, decode(0.5), 1));
}

TEST_CASE("Alpha of a PLY makes surfaces transparent where it is below the largest value") {
  const std::string rgba = "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  const scene::Scene opaque = sceneOf(triangle(rgba, {"1 2 3 255", "1 2 3 255", "1 2 3 255"}));
  CHECK_FALSE(opaque.materials[0].opacity);
  const scene::Scene clear = sceneOf(triangle(rgba, {"1 2 3 255", "1 2 3 51", "1 2 3 0"}));
  CHECK(clear.materials[0].opacity == scene::Opacity{});
  CHECK(clear.meshes[0].colours[1].w == 0.2f);
}

TEST_CASE("A PLY is diffuse: grey without colours, white below them") {
  const scene::Scene plain = sceneOf(triangle("", {"", "", ""}));
  REQUIRE(plain.materials.size() == 1);
  CHECK(kindOf(plain.materials[0]) == scene::MaterialKind::diffuse);
  CHECK(plain.materials[0].diffuse == scene::DiffuseLobe{.colour = glm::vec3(0.8f)});
  const std::string bytes = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  CHECK(sceneOf(triangle(bytes, {"9 9 9", "9 9 9", "9 9 9"})).materials[0].diffuse->colour == glm::vec3(1));
}

TEST_CASE("A PLY is framed, and lit by the default light") {
  const scene::LoadedScene loaded = load(triangle("", {"", "", ""}));
  REQUIRE(loaded.scene.camera);
  CHECK(loaded.scene.camera->at == glm::vec3(0.5f, 0.5f, 0));
  CHECK(loaded.scene.camera->angle == 30);
  CHECK(loaded.scene.background == glm::vec3(0.25f));
  CHECK(loaded.scene.punctualLights.size() == 1);
  CHECK(loaded.facts.at(0) == std::pair<std::string, std::string>("encoding", "ASCII"));
  CHECK(loaded.warnings.empty());
  const scene::LoadedScene lit = load(triangle("", {"", "", ""}), {.environment = {.source = "white"}});
  CHECK(lit.scene.punctualLights.empty());
  CHECK(warningsOf(load(triangle("", {"", "", ""}), {.camera = "left"})) ==
        std::vector<std::string>{
            "test.ply: camera and time have no effect: the format has neither cameras nor animations"});
  CHECK(load(triangle("", {"", "", ""}), {.camera = "none"}).warnings.empty());
}

TEST_CASE("What a PLY has besides is passed over, and named") {
  const scene::LoadedScene loaded = load(
      header("element vertex 3\n" + kPositions +
             "property float confidence\nproperty list uchar float weights\nelement edge 2\nproperty int vertex1\n"
             "property int vertex2\nelement face 1\nproperty uchar red\nproperty list uchar int vertex_indices\n"
             "property list uchar float texcoord\n") +
      "0 0 0 .5 2 1 1\n1 0 0 .5 0\n0 1 0 .5 1 7\n0 1\n1 2\n128 3 0 1 2 6 0 0 1 0 0 1\n");
  CHECK(loaded.scene.meshes[0].indices == Indices{0, 1, 2});
  CHECK(warningsOf(loaded) == std::vector<std::string>{R"(test.ply: not rendered: "red" of "face", "texcoord" of )"
                                                       R"("face", "weights" of "vertex", element "edge")"});
  CHECK(loaded.facts.back() == std::pair<std::string, std::string>("not used", R"("confidence" of "vertex")"));
}

TEST_CASE("What follows the last element of a PLY causes a warning") {
  CHECK(load(triangle("", {"", "", ""}) + " \n\n").warnings.empty());
  CHECK(warningsOf(load(triangle("", {"", "", ""}) + "3 0 1 2\n")) ==
        std::vector<std::string>{"test.ply:14:1: what follows the last element is not read"});
}

TEST_CASE("Long lines of a PLY are errors, or with lenient warnings") {
  const std::string text = triangle("", {"7", "", "8 9"});
  CHECK(
      errorOf(text) ==
      R"(test.ply:10:7: element "vertex" 0: unexpected "7": the header states fewer numbers for the element "vertex")");
  const scene::LoadedScene lenient = load(text, {.lenient = true});
  CHECK(lenient.scene.meshes[0] == meshOf(triangle("", {"", "", ""})));
  CHECK(warningsOf(lenient).size() == 1);
}

TEST_CASE("Texture coordinates of a PLY show the image that a comment names") {
  const TemporaryFolder folder;
  const image::Bytes png = image::encodePng({1, 2, {255, 0, 0, 0, 0, 255}});
  folder.write("a skin.png", {reinterpret_cast<const char*>(png.data()), png.size()});
  const auto names = GENERATE(std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v"));
  const std::string plain = triangle(
      std::string("property float ") + names.first + "\nproperty float " + names.second + "\n",
      {"0 0", ".25 .5", "1 1"});
  std::string text = plain;
  text.insert(text.find("element"), "comment TextureFile a skin.png \n");
  const scene::LoadedScene loaded = load(text, {}, folder.path());
  CHECK(loaded.scene.meshes[0].texCoords[0] == std::vector<glm::vec2>{{0, 0}, {0.25f, 0.5f}, {1, 1}});
  REQUIRE(loaded.scene.images.size() == 1);
  CHECK(loaded.scene.images[0].texels == std::vector<std::uint32_t>{0xff0000ff, 0xffff0000});
  const auto& texture = textureOf(loaded.scene.materials[0], scene::TextureSlot::baseColour);
  REQUIRE(texture);
  CHECK(texture->rowT == glm::vec3(0, -1, 1));
  CHECK(loaded.scene.materials[0].diffuse->colour == glm::vec3(1));
  CHECK(loaded.files.size() == 1);
  CHECK(loaded.warnings.empty());
  CHECK(loaded.scene.hash != load(plain, {}, folder.path()).scene.hash);
  CHECK(load(plain).facts.back().second == "texture coordinates (the file names no image)");
  CHECK(errorOf(text) ==
        "test.ply:3:21: ./a skin.png: cannot open: No such file or directory; lenient leaves out a "
        "texture whose image cannot be read");
  CHECK(load(text, {.lenient = true}).warnings.size() == 1);
}

TEST_CASE("A PLY is recognised by its content, else by its extension") {
  const std::string text = triangle("", {"", "", ""});
  CHECK(formats::loadScene(scene::SceneFile{text, "model.txt", "."}).scene.meshes.size() == 1);
  CHECK_THROWS_WITH(formats::loadScene(scene::SceneFile{"plyx", "model.ply", "."}),
                    "model.ply:1:1: the first line is not \"ply\"");
}

}  // namespace candela::ply
