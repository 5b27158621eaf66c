// The boxes around instances are exact.
#include "host/scene/placed_bounds.h"

#include <catch2/catch.hpp>
#include <random>

#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using glm::vec3;

TEST_CASE("the box around an instance is that of its placed vertices, for any placement") {
  std::mt19937 numbers(1);
  const auto random = [&](float scale) { return std::uniform_real_distribution(-scale, scale)(numbers); };
  test::SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f)));
  scene::Mesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    mesh.positions.push_back(normalize(vec3(random(1), random(1), random(1))) * vec3(1, 2, 3));
    mesh.indices.push_back(i);
  }
  mesh.positions.push_back(vec3(99));  // no triangle has this vertex
  const std::uint32_t stored = storeMesh(b.scene, std::move(mesh));
  for (int i = 0; i < 50; ++i) {
    glm::dmat4 map(1);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) map[column][row] = random(column == 3 ? 1000.0f : 2.0f);
    }
    const std::optional<scene::Placement> placement = scene::placementOf(map);
    if (placement) addInstance(b.scene, stored, *placement, 0);
  }
  scene::PlacedBounds bounds(b.scene);
  for (const scene::PrimitiveRun& run : b.scene.primitives.runs()) {
    vec3 low(INFINITY), high(-INFINITY);
    for (std::uint32_t i = 0; i < b.scene.primitives.countOf(run); ++i) {
      for (const vec3& p : triangleOf(b.scene, run.at(run.first + i)).p) low = min(low, p), high = max(high, p);
    }
    const scene::Bounds found = bounds.of(run);
    CHECK(found.min == low);
    CHECK(found.max == high);
  }
}
