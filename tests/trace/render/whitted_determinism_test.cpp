// The execution of a Whitted render never changes a bit of the image.
#include <catch2/catch.hpp>

#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

render::RenderSettings whittedSettings() {
  render::RenderSettings settings = squareSettings(72, 2);
  settings.image.size.height = 50;  // not a multiple of any workgroup
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = 8;
  settings.image.lightSize = 0.5f;
  return settings;
}

}  // namespace

TEST_CASE("workgroup, segments and tile do not change the image of a tree of rays", "[swiftshader-slow]") {
  const scene::Scene scene = primitivesUnderLights();
  const render::RenderResult base = renderOnDevice(scene, whittedSettings());
  CHECK(base.statistics.kernel == render::KernelInUse::whitted);
  CHECK(base.statistics.treeRays->refracted > 0);
  const auto requireSame = [&](const render::RenderSettings& settings) {
    const render::RenderResult result = renderOnDevice(scene, settings);
    CHECK(result.film.hash() == base.film.hash());
    CHECK(result.statistics.bounceRays == base.statistics.bounceRays);
    CHECK(result.statistics.shadowRays == base.statistics.shadowRays);
    CHECK(result.statistics.vertices == base.statistics.vertices);
    CHECK(result.statistics.treeRays->cameraHits == base.statistics.treeRays->cameraHits);
  };
  for (const std::uint32_t segments : {1u, 4u, 1000u}) {
    render::RenderSettings settings = whittedSettings();
    settings.execution.segmentsPerDispatch = segments;
    requireSame(settings);
  }
  for (const render::Extent tile : {render::Extent{8, 8}, render::Extent{17, 5}}) {
    render::RenderSettings settings = whittedSettings();
    settings.execution.tile = tile;
    settings.execution.segmentsPerDispatch = 3;
    requireSame(settings);
  }
  render::RenderSettings settings = whittedSettings();
  settings.execution.workgroup = {16, 2};
  requireSame(settings);
}

TEST_CASE("the maximum depth of the tree changes the image, and the number of segments does not") {
  const scene::Scene scene = primitivesUnderLights();
  std::vector<std::uint64_t> bounceRays;
  for (const std::uint32_t depth : {1u, 2u, 8u, render::kMaxTreeDepth}) {
    render::RenderSettings settings = whittedSettings();
    settings.image.size = {36, 25};
    settings.image.maxDepth = depth;
    const render::RenderResult free = renderOnDevice(scene, settings);
    settings.execution.segmentsPerDispatch = 1;
    const render::RenderResult stepped = renderOnDevice(scene, settings);
    CAPTURE(depth);
    CHECK(stepped.film.hash() == free.film.hash());
    CHECK(stepped.statistics.bounceRays == free.statistics.bounceRays);
    bounceRays.push_back(free.statistics.bounceRays);
  }
  CHECK(bounceRays[0] == 0);
  CHECK(bounceRays[1] > 0);
  CHECK(bounceRays[2] > bounceRays[1]);
  CHECK(bounceRays[3] > bounceRays[2]);
}

TEST_CASE("the structure and the type of scene loads do not change the image of a tree of rays", "[swiftshader-slow]") {
  const scene::Scene scene = primitivesUnderLights();
  render::RenderSettings settings = whittedSettings();
  settings.execution.sceneLoads = render::SceneLoads::texel;
  const std::uint64_t expected = renderOnDevice(scene, settings).film.hash();
  settings.structure.accel = render::AccelKind::grid;
  const render::RenderResult grid = renderOnDevice(scene, settings);
  CHECK(grid.statistics.structure == render::AccelKind::grid);
  CHECK(grid.film.hash() == expected);
  settings.execution.sceneLoads = render::SceneLoads::storage;
  CHECK(renderOnDevice(scene, settings).film.hash() == expected);
}

TEST_CASE("the number of threads does not change the reference's image of a tree of rays") {
  const scene::Scene scene = primitivesUnderLights();
  render::RenderSettings settings = whittedSettings();
  settings.execution.threads = 1;
  const render::RenderResult one = renderOnReference(scene, settings);
  settings.execution.threads = 2;
  const render::RenderResult two = renderOnReference(scene, settings);
  CHECK(one.film.hash() == two.film.hash());
  CHECK(one.statistics.treeRays->reflected == two.statistics.treeRays->reflected);
}
