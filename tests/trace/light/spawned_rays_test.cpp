// Where rays start: on the surface that was hit, however far away the ray before it started, and far enough from flat
// surfaces that rounding does not put their neighbours in the way. What is seen is known exactly.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <string>

#include "spirv/origin_leaf.h"
#include "tests/trace/device/run_leaf.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

// Returns the number of pixels that do not show half of the sky.
int wrongPixels(const RenderFunction& renderScene, const scene::Scene& scene, std::uint32_t samples) {
  constexpr std::uint32_t kSide = 32;
  const image::Film film = renderScene(scene, squareSettings(kSide, samples)).film;
  int count = 0;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) count += std::abs(pixelLuminance(film, x, y) - 0.5) > 1e-5;
  }
  return count;
}

SceneBuilder underWhiteSky() {
  SceneBuilder b;
  b.scene.background = vec3(1);
  b.material(diffuseMaterial(vec3(0.5f)));
  return b;
}

struct Floor {
  std::string name;
  std::function<void(SceneBuilder&)> add;
};

std::vector<Floor> floors() {
  return {{"a triangle",
           [](SceneBuilder& b) {
             b.triangle({-4, -3, 0}, {4, -3, 0}, {0, 5, 0});
           }},
          {"a plane",
           [](SceneBuilder& b) {
             b.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
           }},
          {"a box", [](SceneBuilder& b) {
             b.box({-1, -1, -1}, {1, 1, 0});
           }}};
}

// Adds a black surface just below the floor, with a hole where the camera looks.
void addHiddenWasher(SceneBuilder& b, float hole, float depth) {
  b.material(diffuseMaterial(vec3(0)));
  const float z = -depth;
  b.quad({hole, -1, z}, {1, -1, z}, {1, 1, z}, {hole, 1, z});
  b.quad({-1, -1, z}, {-hole, -1, z}, {-hole, 1, z}, {-1, 1, z});
  b.quad({-hole, hole, z}, {hole, hole, z}, {hole, 1, z}, {-hole, 1, z});
  b.quad({-hole, -1, z}, {hole, -1, z}, {hole, -hole, z}, {-hole, -hole, z});
}

}  // namespace

TEST_CASE("hits at 1.6 * 10^4 from the camera are put back onto their surface") {
  // The distance has an error of 1e-3. A ray that starts that far below the floor hits what is hidden there.
  onBothTracers([](const RenderFunction& renderScene) {
    for (const Floor& floor : floors()) {
      // The directions of one view are nearly equal, and rounding may happen to be exact for them.
      for (int i = 0; i < 24; ++i) {
        SceneBuilder b = underWhiteSky();
        b.view({1000, 4500.0f - 50.0f * static_cast<float>(i), 16300}, {0, 0, 0}, {0, 1, 0}, 1e-6f);
        floor.add(b);
        addHiddenWasher(b, 0.006f, 2e-5f);
        CAPTURE(floor.name, i);
        CHECK(wrongPixels(renderScene, b.scene, 8) == 0);
      }
    }
  });
}

TEST_CASE("no ray hits the neighbours in a flat mesh of triangles of a few roundings") {
  // The mesh, whose normal is (2, 2, 3), is exactly flat: just above 256 and 128, coordinates are multiples of 2^-15
  // and 2^-16.
  constexpr float kStep = 0x1p-15f;
  const vec3 corner(258, 257, 131);
  constexpr int kCount = 12;
  const auto at = [&](int i, int j) {
    return corner +
           kStep * vec3(static_cast<float>(3 * i), static_cast<float>(3 * j), static_cast<float>(-2 * (i + j)));
  };
  onBothTracers([&](const RenderFunction& renderScene) {
    SceneBuilder b = underWhiteSky();
    for (int i = -kCount; i < kCount; ++i) {
      for (int j = -kCount; j < kCount; ++j) b.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
    const float height = 0x1p-8f;
    b.view(corner + height * vec3(2, 2.5f, 3), corner, {0, 1, 0}, 5);
    CHECK(wrongPixels(renderScene, b.scene, 64) == 0);
  });
}

TEST_CASE("the device moves origins by more than the rounding of two positions") {
  // Both the point on the surface and the origin are rounded by up to half a unit in the last place of each coordinate.
  struct Start {
    glm::vec4 position, normal, direction;
  };
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<Start> starts;
  std::vector<glm::dvec3> points, normals;
  const auto addPlane = [&](const glm::dvec3& centre, const glm::dvec3& unitNormal) {
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 offset(uniform(random), uniform(random), uniform(random));
      points.push_back(centre + 0.01 * (offset - dot(offset, unitNormal) * unitNormal));
      normals.push_back(i % 2 == 0 ? unitNormal : -unitNormal);
      starts.push_back({glm::vec4(points.back(), 0), glm::vec4(unitNormal, 0), glm::vec4(normals.back(), 0)});
    }
  };
  addPlane({257.9, 257.1, 130.8}, glm::normalize(glm::dvec3(-0.485, -0.493, -0.722)));
  addPlane({525.1, 512.2, 515.9}, glm::normalize(glm::dvec3(-0.457, 0.748, -0.482)));
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 centre(1 + uniform(random), 1 + uniform(random), 1 + uniform(random));
    addPlane(512.0 * centre, glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
  }
  const auto count = static_cast<std::uint32_t>(starts.size());
  const auto origins = runLeaf<glm::vec4>(spirv::origin_leaf, starts, count, {count, 0});
  int behind = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    behind += dot(glm::dvec3(origins[i]) - points[i], normals[i]) <= 0;
  }
  CHECK(behind == 0);
}
