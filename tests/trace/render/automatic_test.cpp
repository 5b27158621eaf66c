// Resolution of `automatic`: AutomaticChoices, unless the user chose or the scene does not fit.
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/trace/device/device_scene.h"
#include "host/trace/device/kernel.h"
#include "host/trace/flatten/flatten_hierarchy.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::device {
namespace {

constexpr std::uint64_t kRowBytes = 16;

// Returns the loads that a device with these limits, in records, uses for a scene of 100 records.
render::SceneLoads loadsWhere(std::uint64_t texels, std::uint64_t storageRows, render::SceneLoads asked,
                              render::SceneLoads preferred) {
  vulkan::DeviceInfo info;
  info.maxTexelBufferElements = texels;
  info.maxStorageBufferRange = storageRows * kRowBytes;
  flatten::FlatScene flat;
  flat.rows.resize(100);
  render::RenderSettings settings = render::defaultSettings();
  settings.execution.sceneLoads = asked;
  settings.execution.automatic.sceneLoads = preferred;
  return loadsFor(info, flat, settings);
}

TEST_CASE("requested loads are used, else the preferred ones, else those that fit") {
  using enum render::SceneLoads;
  for (const render::SceneLoads preferred : {render::SceneLoads::texel, storage}) {
    CHECK(loadsWhere(100, 100, render::SceneLoads::texel, preferred) == render::SceneLoads::texel);
    CHECK(loadsWhere(100, 100, storage, preferred) == storage);
    CHECK(loadsWhere(100, 100, automatic, preferred) == preferred);
    CHECK(loadsWhere(100, 99, automatic, preferred) == render::SceneLoads::texel);
    CHECK(loadsWhere(99, 100, automatic, preferred) == storage);
  }
}

TEST_CASE("requested loads that do not fit are refused, and the message names those that do") {
  using enum render::SceneLoads;
  for (const render::SceneLoads preferred : {render::SceneLoads::texel, storage}) {
    CHECK_THROWS_WITH(loadsWhere(99, 100, render::SceneLoads::texel, preferred),
                      Catch::Contains("use loads = storage"));
    CHECK_THROWS_WITH(loadsWhere(100, 99, storage, preferred), Catch::Contains("use loads = texel"));
    CHECK_THROWS_WITH(loadsWhere(99, 99, automatic, preferred), Catch::Contains("make it smaller"));
    CHECK_THROWS_AS(loadsWhere(99, 99, storage, preferred), FileError);
  }
}

TEST_CASE("a requested layout is used, else the preferred one, but midpoint splits have binary nodes") {
  render::RenderSettings settings = render::defaultSettings();
  for (const render::BvhLayout preferred : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
    settings.execution.automatic.bvhLayout = preferred;
    for (const render::BvhSplit split : {render::BvhSplit::sah, render::BvhSplit::midpoint}) {
      settings.structure.bvhSplit = split;
      for (const render::BvhLayout asked : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
        settings.structure.bvhLayout = asked;
        CHECK(flatten::layoutFor(settings) == asked);
      }
      settings.structure.bvhLayout = render::BvhLayout::automatic;
      CHECK(flatten::layoutFor(settings) ==
            (split == render::BvhSplit::midpoint ? render::BvhLayout::bvh2 : preferred));
    }
  }
}

TEST_CASE("a requested workgroup is used, else the preferred one") {
  render::RenderSettings settings = render::defaultSettings();
  CHECK(extentText(settings.execution.workgroupInUse()) == "8x8");
  settings.execution.automatic.workgroup = {32, 1};
  CHECK(extentText(settings.execution.workgroupInUse()) == "32x1");
  settings.execution.workgroup = render::Extent{4, 4};
  CHECK(extentText(settings.execution.workgroupInUse()) == "4x4");
}

TEST_CASE("a requested kernel is used, else the preferred one, except by integrators with a single kernel") {
  render::RenderSettings settings = render::defaultSettings();
  const auto kernel = [&] { return kernelFor(flatten::FlatScene{}, settings).kind; };
  CHECK(kernel() == render::KernelInUse::megakernel);
  settings.execution.automatic.kernel = render::KernelKind::wavefront;
  CHECK(kernel() == render::KernelInUse::wavefront);
  settings.execution.kernel = render::KernelKind::megakernel;
  CHECK(kernel() == render::KernelInUse::megakernel);
  settings.execution.kernel = render::KernelKind::automatic;
  settings.image.integrator = render::Integrator::whitted;
  CHECK(kernel() == render::KernelInUse::whitted);
  settings.image.integrator = render::Integrator::depth;
  CHECK(kernel() == render::KernelInUse::views);
}

}  // namespace
}  // namespace candela::device
