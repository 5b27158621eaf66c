// The execution of a render never changes a bit of the image.
#include <catch2/catch.hpp>

#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

render::RenderSettings baseSettings() {
  render::RenderSettings settings = squareSettings(72, 4);
  settings.image.size.height = 50;  // not a multiple of any workgroup
  return settings;
}

std::uint64_t baseHash(const scene::Scene& scene) { return renderOnDevice(scene, baseSettings()).film.hash(); }

}  // namespace

TEST_CASE("the workgroup does not change the image", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const std::uint64_t expected = baseHash(scene);
  for (const render::Extent workgroup : {render::Extent{16, 4}, render::Extent{64, 1}, render::Extent{1, 1}}) {
    render::RenderSettings settings = baseSettings();
    settings.execution.workgroup = workgroup;
    const render::RenderResult result = renderOnDevice(scene, settings);
    CHECK(result.film.hash() == expected);
    CHECK(result.statistics.workgroup.width == workgroup.width);
    CHECK(result.statistics.workgroup.height == workgroup.height);
  }
}

TEST_CASE("the number of segments per dispatch does not change the image", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const std::uint64_t expected = baseHash(scene);
  std::size_t fewerDispatches = ~std::size_t{0};
  for (const std::uint32_t segments : {1u, 4u, 64u, 1000u}) {
    render::RenderSettings settings = baseSettings();
    settings.execution.segmentsPerDispatch = segments;
    settings.structure.bvhLayout = render::BvhLayout::cwbvh;  // a linear list would reach a device's loop limit sooner
    settings.execution.tile = settings.image.size;  // so that the number of dispatches depends on nothing else
    const render::RenderResult result = renderOnDevice(scene, settings);
    CHECK(result.film.hash() == expected);
    CHECK(result.statistics.maxSegmentsPerDispatch == segments);
    CHECK(result.statistics.dispatchSeconds.size() <= fewerDispatches);
    fewerDispatches = result.statistics.dispatchSeconds.size();
  }
}

TEST_CASE("the tile does not change the image", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const std::uint64_t expected = baseHash(scene);
  for (const render::Extent tile :
       {render::Extent{8, 8}, render::Extent{17, 5}, render::Extent{72, 1}, render::Extent{500, 500}}) {
    render::RenderSettings settings = baseSettings();
    settings.execution.tile = tile;
    const render::RenderResult result = renderOnDevice(scene, settings);
    CHECK(result.film.hash() == expected);
    CHECK(result.statistics.tile.width == std::min(tile.width, settings.image.size.width));
    CHECK(result.statistics.tile.height == std::min(tile.height, settings.image.size.height));
  }
}

TEST_CASE("the structure and the type of scene loads do not change the image", "[swiftshader-slow]") {
  for (const char* name : {"primitives.p3f", "smallpt.p3f"}) {
    const scene::Scene scene = loadTestScene(name);
    render::RenderSettings settings = baseSettings();
    settings.execution.sceneLoads = render::SceneLoads::texel;
    const render::RenderResult texel = renderOnDevice(scene, settings);
    CHECK(texel.statistics.sceneLoads == render::SceneLoads::texel);
    settings.execution.sceneLoads = render::SceneLoads::storage;
    const render::RenderResult storage = renderOnDevice(scene, settings);
    CHECK(storage.statistics.sceneLoads == render::SceneLoads::storage);
    settings.structure.accel = render::AccelKind::none;
    const render::RenderResult bruteForce = renderOnDevice(scene, settings);
    CHECK(bruteForce.statistics.structure == render::AccelKind::none);
    CAPTURE(name);
    CHECK(storage.film.hash() == texel.film.hash());
    CHECK(bruteForce.film.hash() == texel.film.hash());
  }
}

TEST_CASE("the number of threads does not change the reference's image") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  render::RenderSettings settings = baseSettings();
  settings.execution.threads = 1;
  const render::RenderResult one = renderOnReference(scene, settings);
  settings.execution.threads = 2;
  const render::RenderResult two = renderOnReference(scene, settings);
  CHECK(one.statistics.threads == 1);
  CHECK(two.statistics.threads == 2);
  CHECK(one.film.hash() == two.film.hash());
}

TEST_CASE("another seed gives another image") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  render::RenderSettings settings = baseSettings();
  settings.image.seed = 1;
  CHECK(renderOnDevice(scene, settings).film.hash() != baseHash(scene));
}
