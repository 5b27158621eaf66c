// Meshes: which vertices a triangle has, which mesh it is added to.
#include "host/scene/mesh.h"

#include "host/formats/loading/scene_builder.h"
#include "tests/formats/loading/triangles.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

const std::vector<glm::vec3> kCorners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

bool hasVertices(const Triangle& triangle, const std::array<glm::vec3, 3>& vertices) {
  return std::ranges::equal(triangle.p, vertices);
}

}  // namespace

TEST_CASE("a triangle's vertices are consecutive without indices, and chosen by them otherwise") {
  const Mesh soup{.positions = {kCorners[0], kCorners[1], kCorners[2], kCorners[0], kCorners[2], kCorners[3]}};
  const Mesh indexed{.positions = kCorners, .indices = {0, 1, 2, 0, 2, 3}};
  CHECK(triangleCount(soup) == 2);
  CHECK(triangleCount(indexed) == 2);
  for (const std::uint32_t triangle : {0u, 1u}) {
    CHECK(attributeOf(soup, soup.positions, triangle) == attributeOf(indexed, indexed.positions, triangle));
  }
  CHECK(vertexIndex(soup, 1, 2) == 5);
  CHECK(vertexIndex(indexed, 1, 2) == 3);
}

TEST_CASE("a mesh becomes one primitive for each triangle, with its normals") {
  Scene scene;
  addMesh(scene, {.positions = kCorners, .indices = {0, 1, 2}}, 4);
  const std::vector<glm::vec3> normals{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  addMesh(scene, {.positions = kCorners, .normals = normals, .indices = {0, 1, 2, 3, 2, 1}}, 5);
  addMesh(scene, {}, 6);
  REQUIRE(scene.primitives.size() == 3);
  CHECK(scene.meshes.size() == 2);
  CHECK_FALSE(isSmooth(scene, scene.primitives[0]));
  const Primitive& last = scene.primitives[2];
  CHECK((last.mesh == 1 && last.index == 1 && last.material == 5));
  CHECK(hasVertices(triangleOf(scene, last), {kCorners[3], kCorners[2], kCorners[1]}));
  REQUIRE(isSmooth(scene, last));
  CHECK(vertexNormalsOf(scene, last).n[0] == glm::vec3(0, 0, -1));
  CHECK(vertexNormalsOf(scene, last).n[2] == glm::vec3(0, 1, 0));
}

TEST_CASE("statements share one mesh of each kind, and their primitives are in the order of the file") {
  const std::string polygon = "p 3\n0 0 0\n1 0 0\n0 1 0\n", patch = "pp 3\n0 0 0 0 0 1\n2 0 0 0 0 1\n0 2 0 0 0 1\n",
                    mesh = "mesh 3 1\n0 0 0\n3 0 0\n0 3 0\n1 2 3\n";
  const Scene scene = sceneOf(polygon + mesh + patch + mesh + polygon + patch);
  CHECK(scene.meshes.size() == 3);
  const std::vector<Triangle> triangles = trianglesOf(scene);
  REQUIRE(triangles.size() == 6);
  const float sizes[] = {1, 3, 2, 3, 1, 2};
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    CHECK(hasVertices(triangles[i], {{{0, 0, 0}, {sizes[i], 0, 0}, {0, sizes[i], 0}}}));
    CHECK(isSmooth(scene, scene.primitives[i]) == (sizes[i] == 2));
  }
}

TEST_CASE("a mesh statement with vertices that no triangle uses, or without triangles, is read") {
  const Scene scene = sceneOf("mesh 4 1\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n2 3 4\n");
  CHECK(hasVertices(triangleOf(scene, scene.primitives[0]), {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
  CHECK(sceneOf("mesh 3 0\n0 0 0\n1 0 0\n0 1 0\n").meshes.empty());
}

}  // namespace candela::scene
