// Errors of PLY files: each with its place and its exact text.
#include <fmt/format.h>

#include <random>

#include "tests/formats/ply/ply_file.h"

namespace candela::ply {
namespace {

struct Malformed {
  std::string bytes;
  std::string message;  ///< after "test.ply"
};

const std::string kVertices = "element vertex 3\n" + kPositions;
const std::string kRows = "0 0 0\n1 0 0\n0 1 0\n";

const std::vector<Malformed> kMalformed{
    // Headers
    {"ply", ":1:1: the first line is not \"ply\""},
    {"ply\n", ":2:1: the file ends within the header: there is no line \"end_header\""},
    {"ply\nelement vertex 3\n", ":2:1: expected \"format\", then the encoding and \"1.0\""},
    {"ply\nformat text 1.0\n", ":2:8: \"text\" is not ascii, binary_little_endian or binary_big_endian"},
    {"ply\nformat ascii 2.0\n", ":2:14: version \"2.0\" is not 1.0"},
    {"ply\nformat ascii 1.0 x\n", ":2:18: unexpected \"x\""},
    {header("elemnt vertex 3\n"),
     ":3:1: unknown keyword \"elemnt\"; expected element, property, comment, obj_info or end_header"},
    {header("element\n"), ":3:8: expected the name of the element"},
    {header("element vertex three\n"), ":3:16: \"three\" is not the number of the elements \"vertex\""},
    {header("element vertex -1\n"), ":3:16: \"-1\" is not the number of the elements \"vertex\""},
    {header("element vertex 1 1\n"), ":3:18: unexpected \"1\""},
    {header("element a 0\nelement a 0\n"), ":4:9: element \"a\" is stated twice"},
    {header("property float x\n"), ":3:1: a property before any element"},
    {header("element a 0\nproperty flaot x\n"),
     ":4:10: \"flaot\" is not a type: char, uchar, short, ushort, int, uint, float, double or list"},
    {header("element a 0\nproperty float\n"), ":4:15: expected the name of the property"},
    {header("element a 0\nproperty float x\nproperty int x\n"), ":5:14: property \"x\" is stated twice"},
    {header("element a 0\nproperty list float int x\n"), ":4:15: the length of a list is not an integer"},
    {header("element a 1\n"), ":3:11: the element \"a\" has no properties"},
    {header(kVertices + "element face 9\nproperty list uchar int vertex_indices\n") + kRows,
     ":7:14: 9 elements \"face\" are more than the file can contain"},
    {header("element vertex 18446744073709551615\n" + kPositions + kFaces) + kRows,
     ":3:16: 18446744073709551615 elements \"vertex\" are more than the file can contain"},
    {header("element vertex 99\n" + kPositions + kFaces, "binary_little_endian") + "0123456789abc",
     ":3:16: 99 elements \"vertex\" are more than the file can contain"},
    // Missing elements and properties
    {header("element point 1\n" + kPositions) + "0 0 0\n", ": the file has no element \"vertex\""},
    {header("element vertex 1\nproperty float x\nproperty float y\n") + "0 0\n",
     ": the vertices have no positions: the properties x, y and z"},
    {header(kVertices) + kRows, ": the file has no faces: it is a point cloud, which Candela does not render"},
    {header(kVertices + "element face 0\nproperty list uchar int vertex_indices\n") + kRows,
     ": the file has no faces: it is a point cloud, which Candela does not render"},
    {header(kVertices + "element face 1\nproperty int vertex_indices\n") + kRows + "3\n",
     ": the element \"face\" has no list \"vertex_indices\""},
    {header(kVertices + kFaces) + kRows + "2 0 1\n", ": no face has three vertices"},
    // Numbers
    {header(kVertices + kFaces) + "0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n",
     ":10:5: element \"vertex\" 0: \"zero\" is not a number"},
    {header(kVertices + kFaces) + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n",
     ":11:5: element \"vertex\" 1: \"z\" is not a finite number of single precision"},
    {header(kVertices + kFaces) + "0 0 0\n1 0 1e39\n0 1 0\n3 0 1 2\n",
     ":11:5: element \"vertex\" 1: \"1e39\" is beyond the range of single precision"},
    {header(kVertices + kFaces) + kRows + "3 0 1 3\n",
     ":13:7: element \"face\" 0: there is no vertex 3: the file has 3, counted from 0"},
    {header(kVertices + kFaces) + kRows + "3 0 1 -1\n",
     ":13:7: element \"face\" 0: there is no vertex -1: the file has 3, counted from 0"},
    {header(kVertices + kFaces) + kRows + "3 0 1 1.5\n", ":13:7: element \"face\" 0: \"1.5\" is not a whole number"},
    {header(kVertices + kFaces) + kRows + "256 0 1 2\n",
     ":13:1: element \"face\" 0: 256 is outside the range of uchar, 0 to 255"},
    {header(kVertices + "element face 1\nproperty list char int vertex_indices\n") + kRows + "-3 0 1 2\n",
     ":13:1: element \"face\" 0: the list \"vertex_indices\" has the length -3"},
    {header(kVertices + "element face 1\nproperty list int int vertex_indices\n") + kRows + "2000000000 0 1 2\n",
     ":13:1: element \"face\" 0: a list \"vertex_indices\" of 2000000000 numbers is longer than the file"},
    {header(kVertices + kFaces) + kRows + "3 0 1",
     ":13:1: element \"face\" 0: a list \"vertex_indices\" of 3 numbers is longer than the file"},
    {header(kVertices + kFaces + "element edge 1\nproperty int a\n") + kRows + "3 0 1 2\n",
     ":16:1: element \"edge\" 0: the file ends within the element"},
    {header(kVertices + kFaces, "binary_big_endian") + std::string(36, '\0') + "\3\0\0",
     ": element \"face\" 0 at byte 202: a list \"vertex_indices\" of 3 numbers is longer than the file"},
    {header(kVertices + kFaces, "binary_little_endian") + std::string(32, '\0') + std::string("\0\0\x80\x7f", 4) +
         std::string(13, '\3'),
     ": element \"vertex\" 2 at byte 201: \"z\" is not a finite number of single precision"},
    {header(kVertices + kFaces, "binary_little_endian") + std::string(36, '\0') + "\3" + std::string(12, '\3'),
     ": element \"face\" 0 at byte 206: there is no vertex 50529027: the file has 3, counted from 0"},
    {header(kVertices + "element face 1\nproperty list uchar float vertex_indices\n", "binary_little_endian") +
         std::string(36, '\0') + "\3" + std::string(12, '\x3f'),
     ": element \"face\" 0 at byte 208: 0.7470588088035583 is not a whole number"},
};

std::string longFace() {
  std::string text = header(kVertices + "element face 1\nproperty list int int vertex_indices\n") + kRows + "16385";
  for (int i = 0; i < 16385; ++i) text += " 0";
  return text + "\n";
}

}  // namespace

TEST_CASE("A malformed PLY is refused with the place of the error") {
  for (const Malformed& malformed : kMalformed) {
    INFO(malformed.bytes);
    CHECK(errorOf(malformed.bytes) == "test.ply" + malformed.message);
  }
}

TEST_CASE("A face of a PLY with too many vertices is refused") {
  CHECK(errorOf(longFace()) ==
        "test.ply:13:1: element \"face\" 0: the face has 16385 vertices; at most 16384 are read");
}

TEST_CASE("A PLY that is cut off anywhere is refused, or read") {
  const std::string text = triangle(
      "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\n",
      {"0 0 1 1 2 3", "0 0 1 4 5 6", "0 0 1 7 8 9"});
  for (std::size_t size = 0; size + 3 < text.size(); ++size) {
    INFO(size);
    CHECK_FALSE(errorOf(text.substr(0, size)).empty());
  }
}

TEST_CASE("No damage to a PLY crashes its reader") {
  const std::vector<std::string> seeds{
      triangle("property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
               "property uchar blue\n",
               {"0 0 1 1 2 3", "0 0 1 4 5 6", "0 0 1 7 8 9"}),
      header(kVertices + "element tristrips 1\nproperty list int int vertex_indices\n", "binary_little_endian") +
          std::string(36, '\1') + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0", 16)};
  std::mt19937 random(1);
  for (int round = 0; round < 4000; ++round) {
    std::string bytes = seeds[round % seeds.size()];
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<char>(random());
    for (const bool isLenient : {false, true}) {
      try {
        const scene::Scene scene = load(bytes, {.lenient = isLenient}).scene;
        for (const scene::Mesh& mesh : scene.meshes) {
          for (const std::uint32_t index : mesh.indices) REQUIRE(index < mesh.positions.size());
        }
      } catch (const Error& error) {
        REQUIRE(*error.what() != '\0');
      }
    }
  }
}

}  // namespace candela::ply
