// Attributes of meshes at the hits of rays, compared with values computed by hand.
#include <catch2/catch.hpp>

#include "host/trace/reference/geometry.h"
#include "host/trace/reference/surface.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;

namespace {

// A triangle in the plane z = 0 with every attribute, and its indices in another order than its vertices.
scene::Mesh fullMesh() {
  scene::Mesh mesh;
  mesh.positions = {{0, 4, 0}, {0, 0, 0}, {4, 0, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.texCoords = {{{{0, 1}, {0, 0}, {1, 0}}, {{8, 8}, {0, 0}, {0, 0}}}};
  mesh.tangents.assign(3, {1, 0, 0, -1});
  mesh.colours = {{0, 0, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 0}};
  mesh.indices = {1, 2, 0};
  return mesh;
}

// Returns the attributes at the point (1, 2, 0), hit from above or from below.
MeshAttributes attributesOf(const scene::Mesh& mesh, double height = 5) {
  scene::Scene scene;
  scene.materials.emplace_back();
  addMesh(scene, mesh, 0);
  const Ray ray{{1, 2, height}, {0, 0, height > 0 ? -1 : 1}};
  return surfaceAt(scene, ray, {std::abs(height), 0}).attributes;
}

}  // namespace

TEST_CASE("attributes of a mesh are interpolated at the hit of a ray, from both sides") {
  for (const double height : {5., -3.}) {
    const MeshAttributes attributes = attributesOf(fullMesh(), height);  // weights 1/4, 1/4, 1/2
    CHECK(attributes.texCoords[0] == glm::dvec2(0.25, 0.5));
    CHECK(attributes.texCoords[1] == glm::dvec2(4, 4));
    CHECK(attributes.colour == glm::dvec4(0.25, 0.25, 0.5, 0.75));
    CHECK(attributes.tangent == dvec3(1, 0, 0));
    CHECK(attributes.bitangent == dvec3(0, -1, 0));
  }
}

TEST_CASE("a tangent frame has unit tangents, and the geometric normal if vertices have none") {
  scene::Mesh mesh = fullMesh();
  mesh.normals.clear();
  mesh.tangents = {{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, 1}};
  const MeshAttributes attributes = attributesOf(mesh, -5);
  const dvec3 tangent = normalize(dvec3(3, 1, 0));
  CHECK(length(attributes.tangent - tangent) < 1e-15);
  CHECK(length(attributes.bitangent - dvec3(-tangent.y, tangent.x, 0)) < 1e-15);
}

TEST_CASE("attributes that a mesh does not have are 0, and so are those of other primitives") {
  scene::Mesh mesh;
  mesh.positions = fullMesh().positions;
  mesh.colours = fullMesh().colours;
  mesh.indices = fullMesh().indices;
  const MeshAttributes coloured = attributesOf(mesh);
  CHECK(coloured.colour.w == 0.75);
  CHECK(coloured.texCoords[0] == glm::dvec2(0));
  CHECK(coloured.tangent == dvec3(0));
  CHECK(coloured.bitangent == dvec3(0));
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(1))).sphere({0, 0, 0}, 1);
  CHECK(surfaceAt(b.scene, {{0, 0, 5}, {0, 0, -1}}, {4, 0}).attributes.colour == glm::dvec4(0));
}
