// Grid, midpoint BVH, SAH BVH and brute force give the same film.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "host/trace/device/code_form.h"
#include "host/trace/vulkan/loop_limit.h"
#include "shaders/shared/render_data.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

struct Way {
  render::SplitInUse splitInUse;
  render::AccelKind accel;
  render::BvhSplit split = render::BvhSplit::sah;
  float density = 2;
  render::BvhLayout layout = render::BvhLayout::bvh2;
  render::BuildQuality quality = render::BuildQuality::standard;
};

const std::vector<Way> kWays{
    {render::SplitInUse::none, render::AccelKind::none},
    {render::SplitInUse::sah, render::AccelKind::bvh},
    {render::SplitInUse::midpoint, render::AccelKind::bvh, render::BvhSplit::midpoint},
    {render::SplitInUse::none, render::AccelKind::grid},
    {render::SplitInUse::none, render::AccelKind::grid, render::BvhSplit::sah, 1},
    {render::SplitInUse::none, render::AccelKind::grid, render::BvhSplit::sah, 5},
    {render::SplitInUse::sah, render::AccelKind::bvh, render::BvhSplit::sah, 2, render::BvhLayout::cwbvh},
    {render::SplitInUse::midpoint, render::AccelKind::bvh, render::BvhSplit::midpoint, 2, render::BvhLayout::cwbvh}};

render::RenderSettings along(const Way& way, render::RenderSettings settings) {
  settings.structure.accel = way.accel;
  settings.structure.bvhSplit = way.split;
  settings.structure.bvhLayout = way.layout;
  settings.structure.gridDensity = way.density;
  settings.structure.bvhQuality = way.quality;
  return settings;
}

constexpr const char* kView = "v from 0 -6 1.5 at 0 0 .5 up 0 0 1 angle 40 hither 0 resolution 24 24\nb .3 .4 .5\n";

// Spheres that scatter and refract, all of one material, so that scenes of them share kernels.
scene::Scene spheres(const std::vector<glm::vec4>& all) {
  std::string text = std::string(kView) + "f .8 .7 .6 .5 0 0 0 0 1 .5 1.3 0 0 0\n";
  for (const glm::vec4& s : all) text += fmt::format("s {} {} {} {}\n", s.x, s.y, s.z, s.w);
  return sceneFromText(text);
}

// The camera is in the first of them; many others are behind it and beside the view.
scene::Scene spheresAroundTheCamera() {
  std::vector<glm::vec4> all{{0, -6, 1.5, 1}};
  for (int i = 0; i < 25; ++i) all.emplace_back(i - 12, i % 5 * 5 - 15, 0, 0.8f);
  return spheres(all);
}

// Spheres of all sizes, so many that most nodes of the BVH are below its trunk.
scene::Scene cloud() {
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<float>(random()) * 0x1p-32f - 0.5f; };
  std::vector<glm::vec4> all;
  for (int i = 0; i < 4000; ++i) {
    const float size = uniform();
    all.emplace_back(4 * uniform(), 4 * uniform(), 4 * uniform(), 0.01f + 0.5f * size * size);
  }
  return spheres(all);
}

// Triangles, and boxes of zero thickness, all in the plane z = 0.
scene::Scene flatScene() {
  std::string text = std::string(kView) + "f .8 .7 .6 1 0 0 0 0 1 0 1 0 0 0\n";
  for (int i = 0; i < 30; ++i) {
    const double x = 0.2 * i - 3, y = 0.4 * (i % 7) - 1;
    text += fmt::format("p 3 {0} {1} 0 {2} {1} 0 {0} 3 0\nbox {0} -2 0 {2} {1} 0\n", x, y, x + 0.5);
  }
  return sceneFromText(text);
}

// Rays from the plane, up to far beyond the resolution of single precision, towards a light among small spheres.
scene::Scene clusterOnPlane() {
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32 - 0.5; };
  std::string text =
      "b .1 .2 .3\nv from 0 -6 .6 at 0 0 .6 up 0 0 1 angle 60 hither 0 resolution 24 24\n"
      "f .8 .8 .8 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\n";
  for (int i = 0; i < 300; ++i) text += fmt::format("s {} {} {} .03\n", uniform(), uniform(), uniform() + 0.6);
  return sceneFromText(text + "f 0 0 0 1 0 0 0 0 1 0 1 90 80 70\ns 0 0 1.3 .2\n");
}

// 70,000 spheres at one position and one far away, so that a grid has nearly all of them in one cell.
scene::Scene crowdedCell() {
  scene::Scene scene = sceneFromText(std::string(kView) + "f 1 1 1 1 0 0 0 0 1 0 1 0 0 0\ns 1000 1000 1000 1\n");
  for (int i = 0; i < 70000; ++i) {
    scene.primitives.push_back({scene::PrimitiveKind::sphere, static_cast<std::uint32_t>(scene.spheres.size()), 0});
    scene.spheres.push_back({{0, 0, 0.5f + 1e-5f * static_cast<float>(i)}, 0.5f});
  }
  return scene;
}

// Around one point, at 36 distances that double, three clusters of spheres each: a deep BVH, many of whose nodes
// have several interior children.
scene::Scene clustersOfAllSizes() {
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) * 0x1p-32 - 0.5; };
  std::string text = std::string(kView) + "f .8 .7 .6 .5 0 0 0 0 1 .5 1.3 0 0 0\n";
  for (int i = -30; i < 6; ++i) {
    const double size = std::exp2(i);
    for (int cluster = 0; cluster < 3; ++cluster) {
      const double x = std::cos(2.1 * cluster) * size, z = std::sin(2.1 * cluster) * size;
      for (int k = 0; k < 6; ++k) {
        text += fmt::format("s {} {} {} {}\n", x + 0.4 * size * uniform(), 0.4 * size * uniform(),
                            z + 0.4 * size * uniform(), 0.06 * size);
      }
    }
  }
  return sceneFromText(text);
}

// Red spheres, and green ones with higher indices at the same positions.
scene::Scene coincidentSpheres() {
  std::string text = kView;
  for (const char* const colour : {"1 0 0", "0 1 0"}) {
    text += fmt::format("f 0 0 0 1 0 0 0 0 1 0 1 {}\n", colour);
    for (int i = 0; i < 49; ++i) text += fmt::format("s {} 0 {} .25\n", 0.6 * (i % 7) - 1.8, 0.6 * (i / 7) - 1.3);
  }
  return sceneFromText(text);
}

// Triples of spheres that overlap so much that no split is worth it; a band of each is seen.
scene::Scene triples() {
  std::string text = kView;
  int third = 0;
  for (const char* const colour : {"1 0 0", "0 1 0", "0 0 1"}) {
    text += fmt::format("f {} 1 0 0 0 0 1 0 1 0 0 0\n", colour);
    for (int i = 0; i < 9; ++i) text += fmt::format("s {} 0 {} .4\n", i % 3 - 1 + 0.1 * third, i / 3 - 0.5);
    ++third;
  }
  return sceneFromText(text + "l 0 -9 5\n");
}

render::RenderSettings shortPaths(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(side, samples);
  settings.image.maxDepth = 6;
  return settings;
}

// Renders all scenes with one structure before the next, because compiled kernels are then reused.
void requireSameFilms(const std::vector<scene::Scene>& scenes, const render::RenderSettings& settings,
                      const std::vector<Way>& ways) {
  std::vector<std::set<std::uint64_t>> hashes(scenes.size());
  for (const Way& way : ways) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const render::RenderResult result = renderOnDevice(scenes[i], along(way, settings));
      CHECK(result.statistics.structure == way.accel);
      hashes[i].insert(result.film.hash());
    }
  }
  for (const auto& ofScene : hashes) CHECK(ofScene.size() == 1);
}

}  // namespace

TEST_CASE("every structure gives the film of brute force, with its own number of steps", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  std::set<std::uint64_t> hashes, steps;
  for (const Way& way : kWays) {
    const render::RenderResult result = renderOnDevice(scene, along(way, squareSettings(40, 2)));
    CHECK(result.statistics.structure == way.accel);
    CHECK(result.statistics.bvhSplit == way.splitInUse);
    hashes.insert(result.film.hash());
    steps.insert(result.statistics.traversalSteps);
  }
  CHECK(hashes.size() == 1);
  CHECK(steps.size() == kWays.size());
}

TEST_CASE("every quality of a BVH gives the same film with its own number of steps, and is reported",
          "[swiftshader-slow]") {
  const scene::Scene scene = cloud();
  for (const render::BvhLayout layout : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
    std::set<std::uint64_t> hashes, steps;
    for (const render::BuildQuality quality :
         {render::BuildQuality::fast, render::BuildQuality::standard, render::BuildQuality::high}) {
      const Way way{render::SplitInUse::sah, render::AccelKind::bvh, render::BvhSplit::sah, 2, layout, quality};
      const render::RenderResult result = renderOnDevice(scene, along(way, shortPaths(24, 2)));
      hashes.insert(result.film.hash());
      steps.insert(result.statistics.traversalSteps);
      CHECK(result.statistics.bvhQuality == quality);
    }
    CHECK(hashes.size() == 1);
    CHECK(steps.size() == 3);
  }
}

TEST_CASE("at equal distances the lower primitive is hit, with every structure") {
  const scene::Scene scene = coincidentSpheres();
  for (const Way& way : kWays) {
    const image::Film film = renderOnDevice(scene, along(way, shortPaths(24, 1))).film;
    int red = 0, green = 0;
    for (std::uint32_t i = 0; i < 24 * 24; ++i) {
      red += film.mean(i % 24, i / 24).x > 0.9;
      green += film.mean(i % 24, i / 24).y > 0.9;
    }
    CAPTURE(static_cast<int>(way.accel), nameOf(way.splitInUse));
    CHECK(red > 100);
    CHECK(green == 0);
  }
}

TEST_CASE("leaves of an 8-wide BVH with the maximum of three primitives are tested completely") {
  const scene::Scene scene = triples();
  const render::RenderSettings settings = shortPaths(48, 1);
  REQUIRE(renderOnDevice(scene, along(kWays[6], settings)).statistics.structureQuality.at("maxLeafSize") == 3);
  requireSameFilms({scene}, settings, {kWays[0], kWays[6]});
}

TEST_CASE("an 8-wide BVH too deep for the private stack gives the same film") {
  const scene::Scene scene = clustersOfAllSizes();
  const render::RenderSettings settings = shortPaths(24, 2);
  constexpr double kWordsKept = 12;  // wide_bvh.glsl
  REQUIRE(renderOnDevice(scene, along(kWays[6], settings)).statistics.structureQuality.at("depth") > kWordsKept);
  requireSameFilms({scene}, settings, {kWays[0], kWays[6]});
}

TEST_CASE("a requested structure is used even if a linear list would be faster", "[swiftshader-slow]") {
  const scene::Scene scene = spheres({{0, 0, 0, 1}, {1, 1, 1, 0.5}, {-1, 0, 1, 0.4}, {1, -1, 0, 0.3}, {-1, 1, 0, 0.7}});
  REQUIRE(scene.primitives.size() <= gpu::kMaxUniformSlots);
  const render::RenderSettings settings = shortPaths(16, 1);
  const render::RenderResult row = renderOnDevice(scene, settings);
  // Some drivers compile a list too slowly to be given one.
  const bool isList = flatten::isSmall(scene, {}, smallSceneRule(openTestDevice().info()));
  CHECK(row.statistics.layout == (isList ? render::LayoutInUse::list : render::LayoutInUse::cwbvh));
  const render::RenderResult midpoint = renderOnDevice(scene, along(kWays[2], settings));
  CHECK(midpoint.statistics.structureQuality.at("nodes") > 1);
  const render::RenderResult grid = renderOnDevice(scene, along(kWays[3], settings));
  CHECK(grid.statistics.structureQuality.at("cells") > 1);
  const render::RenderResult wide = renderOnDevice(scene, along(kWays[6], settings));
  CHECK(wide.statistics.layout == render::LayoutInUse::cwbvh);
  for (const render::RenderResult& other : {midpoint, grid, wide}) {
    if (isList) CHECK(other.statistics.traversalSteps != row.statistics.traversalSteps);
    CHECK(other.film.hash() == row.film.hash());
  }
}

TEST_CASE("rays with very distant origins lose no hit in a grid", "[swiftshader-slow]") {
  render::RenderSettings settings = squareSettings(48, 4);
  settings.image.maxDepth = 4;
  requireSameFilms({clusterOnPlane()}, settings, {kWays[0], kWays[3]});
}

TEST_CASE("a grid gives the same film of one object, of no object, and from inside an object", "[swiftshader-slow]") {
  requireSameFilms({spheres({{0, 0, 0.5, 1}}), spheresAroundTheCamera()}, shortPaths(24, 2), {kWays[0], kWays[3]});
  requireSameFilms({spheres({})}, shortPaths(24, 2), {kWays[0], kWays[3]});
}

TEST_CASE("a grid gives the same film of a flat scene", "[swiftshader-slow]") {
  requireSameFilms({flatScene()}, shortPaths(24, 2), {kWays[0], kWays[3], kWays[5]});
}

TEST_CASE("a grid gives the same film of overlapping shells, also the coarser one of a device that limits loops",
          "[swiftshader-slow]") {
  const scene::Scene scene = loadSpdScene("shells_1.nff");
  const render::RenderSettings settings = squareSettings(40, 2);
  requireSameFilms({scene}, settings, {kWays[0], kWays[4], kWays[5]});
  const render::RenderResult free = renderOnDevice(scene, along(kWays[3], settings));
  const auto limited = makeGpuRenderer(testDevice(), {.loopLimit = 512});
  const render::RenderResult coarse = limited->render(scene, along(kWays[3], settings), {});
  CHECK(coarse.statistics.structureQuality.at("cells") < free.statistics.structureQuality.at("cells"));
  CHECK(coarse.statistics.structureQuality.at("density") < 2);
  CHECK(coarse.statistics.traversalSteps != free.statistics.traversalSteps);
  CHECK(coarse.film.hash() == free.film.hash());
  CHECK(coarse.film.hash() == renderOnDevice(scene, along(kWays[4], settings)).film.hash());
}

TEST_CASE("a segment too long for the device's loop limit is detected, with every structure", "[swiftshader-slow]") {
  vulkan::Device device = openTestDevice();
  const bool limited = vulkan::probeLoopLimit(device) != vulkan::kUnlimitedIterations;
  // The renderer is configured without a limit, so that it accepts brute force.
  const auto careless = makeGpuRenderer(testDevice(), {.loopLimit = vulkan::kUnlimitedIterations});
  const scene::Scene scene = crowdedCell();
  for (const Way& way : {kWays[0], kWays[2], kWays[3], kWays[6]}) {
    render::RenderSettings settings = along(way, squareSettings(8, 1));
    settings.image.maxDepth = 2;
    const render::RenderResult result = careless->render(scene, settings, {});
    CAPTURE(static_cast<int>(way.accel));
    CHECK((result.statistics.truncated > 0) == limited);
  }
}
