// OBJ: every statement that is rendered, with exact values.
#include "host/formats/load_scene.h"
#include "host/image/colour_transfer.h"
#include "tests/formats/obj/obj_file.h"

namespace candela::obj {
namespace {

using Indices = std::vector<std::uint32_t>;
using Strings = std::vector<std::string>;

/// The positions of the corners of all triangles of a scene, in the order of its primitives.
std::vector<glm::vec3> cornersOf(const scene::Scene& scene) {
  std::vector<glm::vec3> corners;
  for (const scene::Primitive& primitive : scene.primitives) {
    const scene::Triangle triangle = triangleOf(scene, primitive);
    corners.insert(corners.end(), std::begin(triangle.p), std::end(triangle.p));
  }
  return corners;
}

const glm::vec3 kA{0, 0, 0}, kB{1, 0, 0}, kC{1, 1, 0}, kD{0, 1, 0};

}  // namespace

TEST_CASE("OBJ coordinates are rounded once from their decimals") {
  const scene::Scene scene = sceneOf(
      "v 0.1 +.5 -1e-3\nv 1.00000017881393432617187499 1e-60 3 1\nv 16777217 2 -0\nf 1 2 3\n");
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].positions ==
        std::vector<glm::vec3>{{0.1f, 0.5f, -1e-3f}, {1.00000011920928955078125f, 0, 3}, {16777216, 2, -0.0f}});
  CHECK(scene.meshes[0].indices == Indices{0, 1, 2});
  CHECK(scene.meshes[0].normals.empty());
  CHECK(scene.meshes[0].texCoords[0].empty());
}

TEST_CASE("Corners of OBJ have every form, with positive and negative indices") {
  const std::string attributes = kSquare + "vt .25 .5\nvt 1\nvt 0 1 0\nvn 0 0 2\nvn 0 -3 4\nvn 0 1 0\n";
  CHECK(cornersOf(sceneOf(kSquare + "f 1 2 3\nf -4 -2 -1\n")) == std::vector<glm::vec3>{kA, kB, kC, kA, kC, kD});
  const scene::Mesh full = sceneOf(attributes + "f 1/1/1 2/2/2 3/3/3\n").meshes[0];
  CHECK(full.texCoords[0] == std::vector<glm::vec2>{{0.25f, 0.5f}, {1, 0}, {0, 1}});
  CHECK(full.normals == std::vector<glm::vec3>{{0, 0, 1}, {0, -0.6f, 0.8f}, {0, 1, 0}});
  CHECK(sceneOf(attributes + "f -4/-3/-3 -3/-2/-2 -2/-1/-1\n").meshes[0] == full);
  const scene::Mesh texCoords = sceneOf(attributes + "f 1/3 2/2 3/1\n").meshes[0];
  CHECK(texCoords.texCoords[0] == std::vector<glm::vec2>{{0, 1}, {1, 0}, {0.25f, 0.5f}});
  CHECK(texCoords.normals.empty());
  const scene::Mesh normals = sceneOf(attributes + "f 1//3 2//3 3//1\n").meshes[0];
  CHECK(normals.normals == std::vector<glm::vec3>{{0, 1, 0}, {0, 1, 0}, {0, 0, 1}});
  CHECK(normals.texCoords[0].empty());
  CHECK(sceneOf(attributes + "f 1// 2// 3//\n").meshes[0].normals.empty());
  CHECK(sceneOf(attributes + "fo 1/ 2/ 3/\n").meshes[0].texCoords[0].empty());
}

TEST_CASE("Equal corners of OBJ share a vertex") {
  const std::string attributes = kSquare + "vt 0 0\nvt 1 1\n";
  const scene::Mesh mesh = sceneOf(attributes + "f 1/1 2/1 3/1\nf 1/1 3/2 4/1\nf 1/1 3/1 4/1\n").meshes[0];
  CHECK(mesh.indices == Indices{0, 1, 2, 0, 3, 4, 0, 2, 4});
  CHECK(mesh.positions == std::vector<glm::vec3>{kA, kB, kC, kC, kD});
}

TEST_CASE("Polygons of OBJ are triangulated") {
  CHECK(cornersOf(sceneOf(kSquare + "f 1 2 3 4\n")) == std::vector<glm::vec3>{kD, kA, kB, kD, kB, kC});
  // A dart whose reflex vertex is the last: a fan from the first would leave the polygon.
  CHECK(sceneOf("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n").primitives.size() == 2);
  CHECK(warningsOf(load(kSquare + "f 1 3 2 4\n")) ==
        Strings{"test.obj:5:1: the polygon crosses itself; its triangles may overlap"});
}

TEST_CASE("Lines of OBJ continue after a backslash, and end with LF, CR LF or CR") {
  CHECK(cornersOf(sceneOf(kSquare + "f 1\\\n 2 \\\r\n3\n")) == std::vector<glm::vec3>{kA, kB, kC});
  std::string text = "# a comment\r\r" + kSquare + "\tf 1 2 3 # another";
  for (char& c : text) c = c == '\n' ? '\r' : c;
  CHECK(cornersOf(sceneOf(text)) == std::vector<glm::vec3>{kA, kB, kC});
  CHECK(errorsOf(kSquare + "f 1 \\\n 2 x\n") ==
        "test.obj:6:4: expected a corner such as 1, 1/2, 1//3 or 1/2/3, found \"x\"");
  CHECK(load(kSquare + "curv 0 1 \\\n1 2 3\nf 1 2 3\n").scene.primitives.size() == 1);
}

TEST_CASE("Colours of OBJ vertices are decoded from sRGB, and vertices without are white") {
  const scene::Scene scene = sceneOf("v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
  const auto half = static_cast<float>(image::srgbDecode(0.5));
  CHECK(scene.meshes[0].colours == std::vector<glm::vec4>{{1, 1, 1, 1}, {1, half, 0, 1}, {1, 1, 1, 1}});
  CHECK(scene.materials[0].diffuse == scene::DiffuseLobe{.colour = glm::vec3(1)});
}

TEST_CASE("Objects and groups of OBJ have names, in the order of the file") {
  const scene::Scene scene = sceneOf(kSquare +
                                     "f 1 2 3\no Box\ng\ng left side\nf 1 2 3\nf 1 3 4\no empty\ng end\nf 2 3 4\n");
  CHECK(scene.objectNames == Strings{"default", "left side", "end"});
  CHECK(scene.objectStarts == Indices{0, 1, 3});
  CHECK(scene.materialNames == Strings{"default"});
  CHECK(kindOf(scene.materials.at(0)) == scene::MaterialKind::diffuse);
  CHECK(scene.materials[0].diffuse == scene::DiffuseLobe{.colour = glm::vec3(0.8f)});
  CHECK(scene.meshes.size() == 1);
}

TEST_CASE("Names of OBJ objects have no control characters and no bytes that are not UTF-8") {
  const scene::Scene scene = sceneOf(kSquare + "g a\x1b[2J\nf 1 2 3\ng b\xff\xc3\xa9\nf 1 2 3\n");
  CHECK(scene.objectNames == Strings{"a?[2J", "b\xef\xbf\xbd\xc3\xa9"});
}

TEST_CASE("Smoothing groups of OBJ get the mean normal of their triangles by angle") {
  // Two triangles that meet at a right angle along the x axis: each has 45 degrees at both ends of the edge.
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const scene::Mesh smooth = sceneOf(vertices + "s 1\nf 1 2 3\nf 2 1 4\n").meshes[0];
  const float half = static_cast<float>(std::sqrt(0.5));
  REQUIRE(smooth.normals.size() == 4);
  CHECK(glm::length(smooth.normals[0] - glm::vec3(0, half, half)) < 1e-6f);
  CHECK(smooth.normals[2] == glm::vec3(0, 0, 1));
  CHECK(smooth.normals[3] == glm::vec3(0, 1, 0));
  // The vertex 1 has 90 degrees in the first triangle and 45 in the second.
  const scene::Mesh weighted = sceneOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 1\ns 7\nf 1 2 3\nf 2 1 4\n").meshes[0];
  CHECK(glm::length(weighted.normals[0] - glm::normalize(glm::vec3(0, 1, 2))) < 1e-6f);
  // Other groups, and faces without one, share no normals.
  const scene::Mesh separate = sceneOf(vertices + "s 1\nf 1 2 3\ns 2\nf 2 1 4\n").meshes[0];
  CHECK(separate.normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}});
  const scene::Scene off = sceneOf(vertices + "s on\nf 1 2 3\ns off\nf 2 1 4\ns 0\nf 1 2 4\n");
  REQUIRE(off.meshes.size() == 2);
  CHECK(off.meshes[0].normals.empty());
  CHECK(off.meshes[1].normals.size() == 3);
  // Normals of the file take precedence.
  const scene::Mesh stated = sceneOf(vertices + "vn 0 1 0\ns 1\nf 1//1 2//1 3//1\n").meshes[0];
  CHECK(stated.normals == std::vector<glm::vec3>(3, glm::vec3(0, 1, 0)));
}

TEST_CASE("Normals of OBJ of length 0 are replaced by that of a triangle") {
  const scene::Mesh mesh = sceneOf(kSquare + "vn 0 0 0\nvn 1 0 0\nf 1//1 2//2 3//1\n").meshes[0];
  CHECK(mesh.normals == std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 0}, {0, 0, 1}});
}

TEST_CASE("Faces of OBJ with other attributes are other meshes, and stay in order") {
  const scene::Scene scene = sceneOf(kSquare + "vt 0 0\nf 1 2 3\nf 1/1 3/1 4/1\nf 2 3 4\n");
  CHECK(scene.meshes.size() == 2);
  CHECK(cornersOf(scene) == std::vector<glm::vec3>{kA, kB, kC, kA, kC, kD, kB, kC, kD});
}

TEST_CASE("What OBJ has besides faces is named in one warning") {
  const scene::LoadedScene loaded = load(kSquare + "vp 1 2\np 1\nl 1 2\ncstype bezier\ndeg 3\nlod 2\nf 1 2 3\n");
  CHECK(warningsOf(loaded) ==
        Strings{"test.obj: not rendered: curves and surfaces (cstype, deg, vp), display attributes "
                "(lod), lines (l), points (p)"});
  CHECK(loaded.counts == scene::StatementCounts{{"face", 1}, {"object", 1}, {"vertex", 4}});
}

TEST_CASE("Faults of OBJ that lenient passes over") {
  const std::string text = kSquare + "vt 0 0\nfoo 1\nf 1/1 2 3/1\nvt 1 2 3 4\nusemtl grey\nf 1 3 4\nmtllib none.mtl\n";
  const scene::LoadedScene loaded = load(text, {.lenient = true});
  CHECK(loaded.scene.primitives.size() == 2);
  CHECK(warningsOf(loaded).size() == 5);
  CHECK(loaded.scene.meshes[0].texCoords[0].empty());
  CHECK(errorsOf(text) ==
        "test.obj:6:1: unknown keyword \"foo\"; did you mean \"f\"?\n"
        "test.obj:7:1: the corners of the face have different forms\n"
        "test.obj:8:10: unexpected \"4\"\n"
        "test.obj:9:8: no material file defines \"grey\"; lenient renders its faces in grey\n"
        "test.obj:11:8: /nonexistent/none.mtl: cannot open: No such file or directory; lenient reads the file without "
        "it");
}

TEST_CASE("Materials of an OBJ that names no material file are grey, with a warning") {
  const scene::LoadedScene loaded = load(kSquare + "usemtl Default\nf 1 2 3\nusemtl Other\nf 1 3 4\n");
  CHECK(loaded.scene.materials.at(loaded.scene.primitives[0].material).diffuse->colour == glm::vec3(0.8f));
  CHECK(warningsOf(loaded) ==
        Strings{"test.obj:5:8: the file names no material file (mtllib) that could define \"Default\"; "
                "its faces are grey (and 1 more like it)"});
}

TEST_CASE("An OBJ is recognised by its first statement, else by its extension") {
  const auto meshesOf = [](const std::string& text, const std::string& name) {
    return formats::loadScene(scene::SceneFile{text, name, "."}).scene.meshes.size();
  };
  CHECK(meshesOf(kSquare + "f 1 2 3\n", "model.txt") == 1);
  CHECK(meshesOf("# a model\n\n  g all\n" + kSquare + "f 1 2 3\n", "model") == 1);
  CHECK(meshesOf("s off\n" + kSquare + "f 1 2 3\n", "model.nff") == 1);
  const scene::Scene nff = formats::loadScene(scene::SceneFile{"s 0 0 0 1\n", "model.obj", "."}).scene;
  CHECK(nff.spheres.size() == 1);
  CHECK_THROWS_WITH(formats::loadScene(scene::SceneFile{"hello\n", "model.OBJ", "."}),
                    "model.OBJ:1:1: unknown keyword \"hello\"");
}

TEST_CASE("An OBJ is framed, and lit by the default light unless it emits") {
  const scene::LoadedScene loaded = load(kSquare + "f 1 2 3 4\n");
  CHECK(loaded.scene.camera->at == glm::vec3(0.5f, 0.5f, 0));
  CHECK(loaded.scene.punctualLights.size() == 1);
}

}  // namespace candela::obj
