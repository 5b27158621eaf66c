// Instances have the film of copies, bit for bit: docs/light-transport.md section 4.1.
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/trace/light/normal_mapped_meshes.h"
#include "tests/trace/reference/placed_meshes.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;
using glm::dmat4;
using glm::dvec3;
using glm::vec3;
using test::SceneBuilder;

namespace {

// The looks of instances: one material for each two of them.
using Looks = std::vector<scene::Material>;

Looks plainLooks() {
  return {test::diffuseMaterial({0.7f, 0.5f, 0.3f}), test::mixtureMaterial(0.4f, 0.4f, 30),
          test::mirrorMaterial({0.8f, 0.8f, 0.8f}), test::glassMaterial({0.9f, 0.9f, 0.9f}, 1.5f)};
}

Looks texturedLooks() {
  Looks looks{test::mapped({.baseColour = {0.9f, 0.7f, 0.3f}, .metalness = 1, .roughness = 0.3f}),
              test::mapped({.roughness = 0.3f, .transmissionWeight = 0.8f, .isThinWalled = false}),
              test::mapped({.baseColour = {0.3f, 0.5f, 0.8f}, .coatWeight = 0.8f}),
              test::mapped({.baseColour = {0.3f, 0.8f, 0.4f}, .anisotropy = 0.7f})};
  looks.back().opacity = scene::Opacity{.factor = 0.6f};
  return looks;
}

constexpr double kNearest = 3;  // of the centres of instances to the middle

// Instances of one mesh above a plane, in the light of an area light, a point light and the background. Of the scales,
// the smallest is 1/1000 and the largest, of an instance that contains all others, 1000.
scene::Scene ballsOf(const Looks& looks, std::uint32_t seed) {
  SceneBuilder b;
  test::RandomMaps maps(seed);
  b.scene.images = {test::bumps(8)};
  b.material(test::diffuseMaterial(vec3(0.6f))).plane({0, 0, -2}, {1, 0, -2}, {0, 1, -2});
  b.material(test::diffuseMaterial(vec3(0), vec3(6))).quad({-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}, {1, 1, 4});
  const auto firstLook = static_cast<std::uint32_t>(b.scene.materials.size());
  for (const scene::Material& look : looks) b.material(look);
  scene::Mesh mesh = test::ball({0.3f, 0.2f, -0.1f}, 1, 3);
  if (seed % 2 == 1) mesh.colours.assign(mesh.positions.size(), {1, 0.8f, 0.6f, 0.9f});
  const std::uint32_t stored = test::storeBoth(b.scene, mesh);
  for (std::uint32_t i = 0; i < 16; ++i) {
    const dvec3 centre(maps.number(-kNearest, kNearest), maps.number(-kNearest, kNearest), maps.number(-2, 2));
    const std::uint32_t look = firstLook + i / 2 % static_cast<std::uint32_t>(looks.size());
    const bool isSmall = i >= 12;
    test::addInstance(b.scene, maps.next(isSmall ? 1e-3 : maps.number(0.3, 1.2), isSmall ? dvec3(0, -6.98, 1) : centre),
                      stored, look);
  }
  if (seed % 3 == 0) {
    b.material(test::diffuseMaterial(vec3(0.5f)));
    const auto dome = static_cast<std::uint32_t>(b.scene.materials.size() - 1);
    for (int i = 0; i < 2; ++i) test::addInstance(b.scene, maps.next(1000, dvec3(0)), stored, dome);
  }
  b.pointLight({-4, -4, 4}, vec3(0.3f));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1}, {0, 0, 0}, {0, 0, 1}, 50);
  return b.scene;
}

render::RenderSettings settingsFor(std::uint32_t side) {
  render::RenderSettings settings = squareSettings(side, 2);
  settings.image.maxDepth = 6;
  settings.structure.bvhLayout = render::BvhLayout::cwbvh;
  return settings;
}

double instanceCount(const render::RenderResult& result) {
  const auto found = result.statistics.structureQuality.find("instances");
  return found == result.statistics.structureQuality.end() ? 0 : found->second;
}

// Checks that a device stores at least `least` instances, and that their film is that of copies.
void requireFilmOfCopies(const scene::Scene& scene, render::RenderSettings settings, double least) {
  const render::RenderResult instances = renderOnDevice(scene, settings);
  CHECK(instanceCount(instances) >= least);
  settings.structure.copiesInstances = true;
  const render::RenderResult copies = renderOnDevice(scene, settings);
  CHECK(instanceCount(copies) == 0);
  CHECK(instances.film.hash() == copies.film.hash());
}

// A square of 8 x 8 cells in the plane z = 0, with sides of two units.
scene::Mesh tiledSquare() {
  constexpr std::uint32_t kCells = 8;
  scene::Mesh mesh;
  for (std::uint32_t y = 0; y <= kCells; ++y) {
    for (std::uint32_t x = 0; x <= kCells; ++x) {
      mesh.positions.emplace_back(2.0f * static_cast<float>(x) / kCells - 1, 2.0f * static_cast<float>(y) / kCells - 1,
                                  0);
      if (x == kCells || y == kCells) continue;
      const std::uint32_t at = y * (kCells + 1) + x;
      mesh.indices.insert(mesh.indices.end(), {at, at + 1, at + kCells + 2, at, at + kCells + 2, at + kCells + 1});
    }
  }
  return mesh;
}

// Instances that lie in one plane with each other, with their own copies, and with a floor and a lamp.
scene::Scene stackedSquares(float height) {
  SceneBuilder b;
  const auto at = [&](double x, double y, double angle, double size) {
    const dmat4 moved = glm::translate(dmat4(1), dvec3(x, y, height));
    return glm::scale(glm::rotate(moved, angle, dvec3(0, 0, 1)), dvec3(size));
  };
  b.material(test::diffuseMaterial({0.7f, 0.6f, 0.5f})).plane({0, 0, height}, {1, 0, height}, {0, 1, height});
  b.material(test::diffuseMaterial(vec3(0), vec3(3)));
  b.quad({-0.5f, -0.5f, height}, {0.5f, -0.5f, height}, {0.5f, 0.5f, height}, {-0.5f, 0.5f, height});
  b.material(test::diffuseMaterial({0.2f, 0.5f, 0.8f}));
  b.material(test::glassMaterial(vec3(0.9f), 1.5f));
  const std::uint32_t stored = test::storeBoth(b.scene, tiledSquare());
  for (int i = 0; i < 6; ++i) test::addInstance(b.scene, at(0.7 * i - 2, 0.3 * i, 0.5 * i, 1.5), stored, 2);
  for (int i = 0; i < 2; ++i) test::addInstance(b.scene, at(-1, 1, 0.25, 1), stored, 2);  // equal
  for (int i = 0; i < 2; ++i) test::addInstance(b.scene, at(1, -1, 0.75, 2), stored, 3);  // equal, of glass
  b.scene.background = vec3(0.4f);
  b.view({0, -5, height + 4}, {0, 0, height}, {0, 0, 1}, 50);
  return b.scene;
}

}  // namespace

TEST_CASE("instances of any placement have the film of copies") {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    CAPTURE(seed);
    requireFilmOfCopies(ballsOf(seed < 3 ? plainLooks() : texturedLooks(), seed), settingsFor(24), 8);
  }
}

TEST_CASE("instances of 24 more scenes have the film of copies", "[slow]") {
  for (std::uint32_t seed = 6; seed < 30; ++seed) {
    CAPTURE(seed);
    requireFilmOfCopies(ballsOf(seed % 4 < 2 ? plainLooks() : texturedLooks(), seed), settingsFor(48), 8);
  }
}

TEST_CASE("instances have the film of copies with every kernel and integrator") {
  render::RenderSettings settings = settingsFor(24);
  const scene::Scene plain = ballsOf(plainLooks(), 1);
  SECTION("wavefront") {
    settings.execution.kernel = render::KernelKind::wavefront;
    requireFilmOfCopies(plain, settings, 8);
    requireFilmOfCopies(ballsOf(texturedLooks(), 3), settings, 8);
  }
  SECTION("Whitted") {
    settings.image.integrator = render::Integrator::whitted;
    requireFilmOfCopies(plain, settings, 8);
  }
  SECTION("views") {
    for (const render::Integrator integrator :
         {render::Integrator::ao, render::Integrator::normal, render::Integrator::albedo, render::Integrator::depth,
          render::Integrator::id}) {
      settings.image.integrator = integrator;
      requireFilmOfCopies(plain, settings, 8);
    }
  }
  SECTION("layers and parts of dispatches") {
    settings.image.layers = image::withSums({~0u});
    settings.execution.segmentsPerDispatch = 1;
    settings.execution.tile = render::Extent{8, 8};
    requireFilmOfCopies(plain, settings, 8);
  }
  SECTION("Whitted, in parts") {
    settings.image.integrator = render::Integrator::whitted;
    settings.execution.segmentsPerDispatch = 1;
    requireFilmOfCopies(plain, settings, 8);
  }
  SECTION("with a light tree") {
    settings.image.lights = render::LightSelection::tree;
    Looks glowing = texturedLooks();
    glowing.front().emission = {3, 2, 1};
    requireFilmOfCopies(ballsOf(glowing, 3), settings, 6);
  }
  SECTION("without next-event estimation, one-sided") {
    settings.image.nextEventEstimation = false;
    settings.image.oneSided = true;
    requireFilmOfCopies(plain, settings, 8);
  }
}

TEST_CASE("instances that coincide with other surfaces have the film of copies") {
  for (const float height : {0.0f, 100.0f}) requireFilmOfCopies(stackedSquares(height), settingsFor(32), 6);
}

TEST_CASE("grids, binary BVHs and brute force copy instances, with the same film") {
  const scene::Scene scene = ballsOf(plainLooks(), 2);
  render::RenderSettings settings = settingsFor(24);
  const std::uint64_t expected = renderOnDevice(scene, settings).film.hash();
  for (const render::AccelKind accel : {render::AccelKind::grid, render::AccelKind::none}) {
    settings.structure.accel = accel;
    const render::RenderResult copies = renderOnDevice(scene, settings);
    CHECK(instanceCount(copies) == 0);
    CHECK(copies.film.hash() == expected);
  }
  settings.structure.accel = render::AccelKind::bvh;
  settings.structure.bvhSplit = render::BvhSplit::midpoint;
  for (const render::BvhLayout layout : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
    settings.structure.bvhLayout = layout;
    CHECK(renderOnDevice(scene, settings).film.hash() == expected);
  }
}
