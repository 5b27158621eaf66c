// Bump maps on both tracers: the same pixels at equal seeds, and the normals of displaced planes.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/image/image.h"
#include "host/scene/placement.h"
#include "tests/trace/light/normal_mapped_meshes.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using namespace candela::test;
using glm::dvec3;
using glm::vec3;
using test::SceneBuilder;

namespace {

scene::TextureImage heights(std::uint32_t side) {
  std::mt19937 random(7);
  scene::TextureImage image{"heights", side, side, {}};
  for (std::uint32_t i = 0; i < side * side; ++i) image.texels.push_back(static_cast<std::uint32_t>(random()));
  return image;
}

scene::Material bumped(const scene::SurfaceParameters& surface, float scale,
                       const scene::TextureReference& texture = {}) {
  scene::Material material = mapped(surface);
  material.textures[static_cast<std::size_t>(scene::TextureSlot::normal)] = texture;
  material.normalScale = scale;
  material.hasHeights = true;
  return material;
}

// A floor, a ball with smooth normals, and two instances of another, one of which is stretched and mirrored.
scene::Scene ballsWithHeights() {
  SceneBuilder b;
  b.scene.images = {heights(8)};
  b.material(bumped({.baseColour = {0.7f, 0.6f, 0.5f}, .roughness = 0.6f}, 0.2f, {.rowS = {3, 1, 0.2f}}));
  addMesh(b.scene, flatSquare(6), 0);
  b.material(bumped({.baseColour = {0.9f, 0.7f, 0.3f}, .metalness = 1, .roughness = 0.4f}, 0.1f));
  b.scene.materials.back().hasFacets = false;
  addMesh(b.scene, ball({-2, 0, 1}, 0.9f, 3), 1);
  b.material(bumped({.baseColour = {0.3f, 0.5f, 0.8f}, .roughness = 0.4f}, -0.05f,
                    {.wrapS = scene::TextureWrap::mirroredRepeat, .filter = scene::TextureFilter::nearest}));
  const std::uint32_t mesh = scene::storeMesh(b.scene, ball({0, 0, 0}, 0.9f, -3));
  glm::dmat4 placed(1), stretched(1);
  placed[3] = {0, 0, 1, 1};
  stretched[0] = {-0.7, 0, 0, 0};
  stretched[2] = {0, 0.3, 1.2, 0};
  stretched[3] = {2, 0, 1, 1};
  for (const glm::dmat4& map : {placed, stretched})
    scene::addInstance(b.scene, mesh, scene::placementOf(map).value(), 2);
  b.material(test::diffuseMaterial(vec3(0.5f), vec3(6)));
  b.quad({-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}, {1, 1, 4});
  b.pointLight({-4, -4, 4}, vec3(0.3f));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 3}, {0, 0, 0.8f}, {0, 0, 1}, 45);
  b.scene.name = "balls with heights";
  return b.scene;
}

// The normal that the view of normals shows in the middle of a square of side 2, whose left texel has the height 0, and
// whose right one has the height `scale` times 0.2.
dvec3 normalOfRamp(const RenderFunction& render, float scale, const scene::TextureReference& texture,
                   const glm::dmat4& map) {
  SceneBuilder b;
  b.scene.images = {{"", 2, 1, {0xff000000u, 0xff000033u}}};
  b.material(bumped({}, scale, texture));
  scene::Mesh mesh = flatSquare(1);
  for (vec3& position : mesh.positions) position = vec3(map * glm::dvec4(dvec3(position), 1));
  addMesh(b.scene, mesh, 0);
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 1);
  render::RenderSettings settings = squareSettings(4, 1);
  settings.image.integrator = render::Integrator::normal;
  return 2.0 * dvec3(image::toImage(render(b.scene, settings).film).at(2, 2)) - 1.0;
}

void checkNear(const dvec3& found, const dvec3& expected) { CHECK(length(found - normalize(expected)) < 1e-5); }

}  // namespace

TEST_CASE("bump maps have the reference's pixels at equal seeds") {
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    settings.image.maxDepth = 4;
    checkPixelsAgree(ballsWithHeights(), settings);
  }
}

TEST_CASE("views show the normals of bump maps", "[swiftshader-slow]") {
  render::RenderSettings settings = squareSettings(64, 1);
  settings.image.integrator = render::Integrator::normal;
  checkPixelsAgree(ballsWithHeights(), settings);
}

TEST_CASE("a ramp of heights has the normal of the plane that it makes") {
  onBothTracers([](const RenderFunction& render) {
    const auto clamped = [](const vec3& rowS, const vec3& rowT) {
      constexpr scene::TextureWrap kEdge = scene::TextureWrap::clampToEdge;
      return scene::TextureReference{.wrapS = kEdge, .wrapT = kEdge, .rowS = rowS, .rowT = rowT};
    };
    const scene::TextureReference plain = clamped({1, 0, 0}, {0, 1, 0});
    glm::dmat4 wide(1), tilted(1);
    wide[0] = {4, 0, 0, 0};
    tilted[0] = {1, 0, 0.5, 0};
    // The centres of both texels are 1 apart.
    checkNear(normalOfRamp(render, 3, plain, glm::dmat4(1)), {-0.6, 0, 1});
    checkNear(normalOfRamp(render, -3, plain, glm::dmat4(1)), {0.6, 0, 1});
    checkNear(normalOfRamp(render, 3, plain, wide), {-0.15, 0, 1});
    checkNear(normalOfRamp(render, 3, clamped({2, 0, -0.5f}, {0, 1, 0}), glm::dmat4(1)), {-1.2, 0, 1});
    // v runs along -y.
    checkNear(normalOfRamp(render, 3, clamped({0, 1, 0}, {1, 0, 0}), glm::dmat4(1)), {0, 0.6, 1});
    // The displacement by 0.6 is along the normal (-0.5, 0, 1) / sqrt(1.25), over a length of sqrt(1.25).
    const dvec3 up = normalize(dvec3(-0.5, 0, 1)), along = normalize(dvec3(1, 0, 0.5));
    checkNear(normalOfRamp(render, 3, plain, tilted), up - 0.6 / std::sqrt(1.25) * along);
  });
}
