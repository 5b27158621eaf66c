// What `automatic` stands for: AutomaticChoices where nothing was asked for and the scene fits.
#include <catch2/catch.hpp>

#include "host/core/errors.h"
#include "host/render/device_scene.h"
#include "host/render/flatten_hierarchy.h"
#include "host/render/kernel.h"

namespace candela {
namespace {

constexpr std::uint64_t kRowBytes = 16;

// A device that binds so many rows, and what is in use there of a scene of 100.
SceneLoads loadsWhere(std::uint64_t texels, std::uint64_t storageRows, SceneLoads asked, SceneLoads preferred) {
  DeviceInfo info;
  info.maxTexelBufferElements = texels;
  info.maxStorageBufferRange = storageRows * kRowBytes;
  FlatScene flat;
  flat.rows.resize(100);
  RenderSettings settings;
  settings.sceneLoads = asked;
  settings.automatic.sceneLoads = preferred;
  return loadsFor(info, flat, settings);
}

TEST_CASE("loads that are asked for are used, others as preferred, and where the scene does not fit so the other way") {
  using enum SceneLoads;
  for (const SceneLoads preferred : {texel, storage}) {
    CHECK(loadsWhere(100, 100, texel, preferred) == texel);
    CHECK(loadsWhere(100, 100, storage, preferred) == storage);
    CHECK(loadsWhere(100, 100, automatic, preferred) == preferred);
    CHECK(loadsWhere(100, 99, automatic, preferred) == texel);
    CHECK(loadsWhere(99, 100, automatic, preferred) == storage);
  }
}

TEST_CASE("loads that are asked for and do not fit are refused with the way that does, whatever is preferred") {
  using enum SceneLoads;
  for (const SceneLoads preferred : {texel, storage}) {
    CHECK_THROWS_WITH(loadsWhere(99, 100, texel, preferred), Catch::Contains("use storage loads"));
    CHECK_THROWS_WITH(loadsWhere(100, 99, storage, preferred), Catch::Contains("use texel loads"));
    CHECK_THROWS_WITH(loadsWhere(99, 99, automatic, preferred), Catch::Contains("make it smaller"));
    CHECK_THROWS_AS(loadsWhere(99, 99, storage, preferred), FileError);
  }
}

TEST_CASE("a layout that is asked for is used, others as preferred, but midpoint splits have two-wide nodes") {
  RenderSettings settings;
  for (const BvhLayout preferred : {BvhLayout::bvh2, BvhLayout::cwbvh}) {
    settings.automatic.bvhLayout = preferred;
    for (const BvhSplit split : {BvhSplit::sah, BvhSplit::midpoint}) {
      settings.bvhSplit = split;
      for (const BvhLayout asked : {BvhLayout::bvh2, BvhLayout::cwbvh}) {
        settings.bvhLayout = asked;
        CHECK(layoutFor(settings) == asked);
      }
      settings.bvhLayout = BvhLayout::automatic;
      CHECK(layoutFor(settings) == (split == BvhSplit::midpoint ? BvhLayout::bvh2 : preferred));
    }
  }
}

TEST_CASE("a workgroup that is asked for is used, else the preferred one") {
  RenderSettings settings;
  CHECK(extentText(settings.workgroupInUse()) == "8x8");
  settings.automatic.workgroup = {32, 1};
  CHECK(extentText(settings.workgroupInUse()) == "32x1");
  settings.workgroup = Extent{4, 4};
  CHECK(extentText(settings.workgroupInUse()) == "4x4");
}

TEST_CASE("a kernel that is asked for is used, others as preferred, but integrators that have but one keep it") {
  RenderSettings settings;
  const auto nameOf = [&] { return std::string(kernelFor(FlatScene{}, settings).name); };
  CHECK(nameOf() == "megakernel");
  settings.automatic.kernel = KernelKind::wavefront;
  CHECK(nameOf() == "wavefront");
  settings.kernel = KernelKind::megakernel;
  CHECK(nameOf() == "megakernel");
  settings.kernel = KernelKind::automatic;
  settings.integrator = Integrator::whitted;
  CHECK(nameOf() == "whitted");
  settings.integrator = Integrator::depth;
  CHECK(nameOf() == "views");
}

}  // namespace
}  // namespace candela
