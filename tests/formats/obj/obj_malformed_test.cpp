// Errors of OBJ files: each with its place and its exact text.
#include <random>

#include "tests/formats/obj/obj_file.h"

namespace candela::obj {
namespace {

struct MalformedText {
  std::string text;     ///< after kSquare and a face
  std::string message;  ///< after "test.obj:"
};

const std::string kBefore = kSquare + "f 1 2 3\n";

const std::vector<MalformedText> kMalformedTexts{
    {"v 1 2\n", "6:6: expected a coordinate"},
    {"v 1 2 x\n", "6:7: expected a coordinate, found \"x\""},
    {"v 1 nan 2\n", "6:5: \"nan\" is not a finite number"},
    {"v 1 2 1e39\n", "6:7: \"1e39\" is beyond the range of single precision"},
    {"v 1 2 3 4 5\n", "6:12: expected a colour"},
    {"v 1 2 3 1 1 1 1\n", "6:15: unexpected \"1\""},
    {"vt\n", "6:3: expected a texture coordinate"},
    {"vt 0 0 0 0\n", "6:10: unexpected \"0\""},
    {"vn 0 1\n", "6:7: expected a component of the normal"},
    {"f 1 2\n", "6:1: a face has at least three vertices"},
    {"f 0 1 2\n", "6:3: there is no vertex 0: 4 so far, counted from 1, or from -1 backwards"},
    {"f 1 2 5\n", "6:7: there is no vertex 5: 4 so far, counted from 1, or from -1 backwards"},
    {"f -1 -2 -5\n", "6:9: there is no vertex -5: 4 so far, counted from 1, or from -1 backwards"},
    {"f 1/1 2/1 3/1\n", "6:5: there is no texture coordinate 1: 0 so far, counted from 1, or from -1 backwards"},
    {"f 1//1 2//1 3//1\n", "6:6: there is no normal 1: 0 so far, counted from 1, or from -1 backwards"},
    {"f 1 2 3.5\n", "6:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"3.5\""},
    {"f 1 2 99999999999999999999\n",
     "6:7: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"99999999999999999999\""},
    {"vn 0 0 1\nf 1//1 2 3\n", "7:1: the corners of the face have different forms"},
    {"s\n", "6:2: expected the number of a smoothing group, or off"},
    {"s one\n", "6:3: \"one\" is not the number of a smoothing group, or off"},
    {"s 1 2\n", "6:5: unexpected \"2\""},
    {"usemtl\n", "6:7: expected the name of a material"},
    {"mtllib\n", "6:1: expected the name of a file"},
    {"vertx 1\n", "6:1: unknown keyword \"vertx\"; did you mean \"v\"?"},
    {"\x1b[2J\n", "6:1: unknown keyword \"?[2J\""},
    {"mtllib ../../etc/passwd\n",
     "6:8: \"/nonexistent/../../etc/passwd\" is outside the scene's folder; allow-path = DIR permits it; lenient reads "
     "the "
     "file without it"},
};

}  // namespace

TEST_CASE("A malformed OBJ is refused with the place of each error") {
  for (const MalformedText& malformed : kMalformedTexts) {
    INFO(malformed.text);
    CHECK(errorsOf(kBefore + malformed.text) == "test.obj:" + malformed.message);
  }
  CHECK(errorsOf(kSquare + "l 1 2\n") == "test.obj: the file has no faces, and points and lines are not rendered");
}

TEST_CASE("A face of OBJ with too many vertices is refused") {
  std::string text = kSquare + "f";
  for (int i = 0; i < 16385; ++i) text += " 1";
  CHECK(errorsOf(text) == "test.obj:5:1: a face of more than 16384 vertices");
}

TEST_CASE("No damage to an OBJ crashes its reader") {
  const std::string seed = kSquare +
                           "vt 0 0\nvt 1 1\nvn 0 0 1\ng a\ns 1\nusemtl x\nf 1/1/1 2/2/-1 3/1/1 -1/2/1\nf 1 2 3\n"
                           "o b\ns off\nf 1//1 2//1 \\\n3//1\np 1\n";
  std::mt19937 random(1);
  for (int round = 0; round < 4000; ++round) {
    std::string text = seed;
    for (int i = 0; i < 3; ++i) text[random() % text.size()] = static_cast<char>(random());
    for (const bool isLenient : {false, true}) {
      try {
        const scene::Scene scene = load(text, {.lenient = isLenient}).scene;
        for (const scene::Mesh& mesh : scene.meshes) {
          for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.positions.size());
        }
        for (const scene::Primitive& primitive : scene.primitives) {
          REQUIRE(primitive.material < scene.materials.size());
          REQUIRE(primitive.index < triangleCount(scene.meshes[primitive.mesh]));
        }
      } catch (const Error& error) {
        REQUIRE(*error.what() != '\0');
      }
    }
  }
}

}  // namespace candela::obj
