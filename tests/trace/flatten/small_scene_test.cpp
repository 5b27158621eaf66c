// Scenes that are traced as a linear list, without a structure.
#include "host/trace/flatten/small_scene.h"

#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "host/formats/nff/nff_loader.h"
#include "host/trace/device/code_form.h"
#include "host/trace/flatten/flat_scene.h"
#include "shaders/shared/scene_rows.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::device {
namespace {

scene::Scene scattered(const char* statement, int count) {
  std::string text = "v from 0 -6 1 at 0 0 0 up 0 0 1 angle 40 hither 0 resolution 8 8\nf 1 1 1 1 0 0 0 0 1\n";
  for (int i = 0; i < count; ++i) text += statement;
  return scene::parseScene(text, "test", ".").scene;
}

constexpr const char* kSphere = "s 0 0 0 1\n";
constexpr const char* kCone = "c 0 0 0 1 0 0 1 0\n";
constexpr const char* kTriangle = "p 3\n0 0 0\n1 0 0\n0 1 0\n";

vulkan::DeviceInfo deviceWith(const char* type, std::uint32_t subgroupSize) {
  vulkan::DeviceInfo info;
  info.type = type;
  info.subgroupSize = subgroupSize;
  return info;
}

}  // namespace

TEST_CASE("whether a scene is small depends on the cost of its primitives, not only on their number") {
  const flatten::SmallSceneRule rule{.maxCost = 48, .rowsAhead = false};
  CHECK(isSmall(scattered(kTriangle, 16), {}, rule));
  CHECK(!isSmall(scattered(kTriangle, 17), {}, rule));
  CHECK(isSmall(scattered(kSphere, 24), {}, rule));
  CHECK(!isSmall(scattered(kSphere, 25), {}, rule));
  CHECK(isSmall(scattered(kCone, 3), {}, rule));
  CHECK(!isSmall(scattered(kCone, 4), {}, rule));
  CHECK(isSmall(scattered(kCone, 0), {}, rule));
}

TEST_CASE("no scene with more primitives than the uniform buffer can store is small") {
  const flatten::SmallSceneRule all{.maxCost = 1000, .rowsAhead = false};
  CHECK(isSmall(scattered(kSphere, gpu::kMaxUniformSlots), {}, all));
  CHECK(!isSmall(scattered(kSphere, gpu::kMaxUniformSlots + 1), {}, all));
}

TEST_CASE("a small scene has at most four surfaces that coincide, which come last") {
  const flatten::SmallSceneRule rule{.maxCost = 48, .rowsAhead = false};
  std::vector<bool> coincident(8, false);
  std::fill_n(coincident.begin() + 2, 4, true);
  CHECK(isSmall(scattered(kSphere, 8), coincident, rule));
  coincident[7] = true;
  CHECK(!isSmall(scattered(kSphere, 8), coincident, rule));

  const scene::Scene
      scene = scene::parseScene(
                  "v from 0 -6 1 at 0 0 0 up 0 0 1 angle 40 hither 0 resolution 8 8\nf 1 1 1 1 0 0 0 0 1\n"
                  "box 0 0 0 1 1 1\ns 3 0 2 1\npl 0 0 0 1 0 0 0 1 0\ns -3 0 2 1\n",
                  "test", ".")
                  .scene;
  const flatten::FlatScene flat = flatten::flattenScene(scene, render::defaultSettings(),
                                                        {.maxGridSide = flatten::kAnyGridSide, .smallScene = rule});
  CHECK(flat.shape.uniformSlots == 4);
  CHECK(flat.shape.firstMarkedSlot == 2);
  for (std::uint32_t slot = 0; slot < 4; ++slot) {
    const bool marked = (flat.slotRows[slot * gpu::kPrimitiveRows + 2].w & gpu::kFlagCoincident) != 0;
    CHECK(marked == (slot >= 2));
  }
}

TEST_CASE(
    "processors with wide vectors have longer lists than GPUs, and read them ahead, and other processors have none") {
  const flatten::SmallSceneRule wide = smallSceneRule(deviceWith("CPU", 8));
  const flatten::SmallSceneRule narrow = smallSceneRule(deviceWith("CPU", 4));
  const flatten::SmallSceneRule gpu = smallSceneRule(deviceWith("discrete GPU", 32));
  CHECK(isSmall(scattered(kTriangle, 40), {}, wide));
  CHECK(!isSmall(scattered(kTriangle, 1), {}, narrow));
  CHECK(isSmall(scattered(kTriangle, 16), {}, gpu));
  CHECK(!isSmall(scattered(kTriangle, 17), {}, gpu));
  CHECK(wide.rowsAhead);
  CHECK(!narrow.rowsAhead);
  CHECK(!gpu.rowsAhead);
}

TEST_CASE("a small scene has its records in the uniform buffer too, unless a structure is requested") {
  const scene::Scene scene = formats::loadScene(std::filesystem::path(CANDELA_SOURCE_DIR) / "scenes" / "cornell.p3f")
                                 .scene;
  const flatten::FlattenLimits limits{.maxGridSide = flatten::kAnyGridSide,
                                      .smallScene = {.maxCost = 128, .rowsAhead = false}};
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {8, 8};
  const flatten::FlatScene row = flatten::flattenScene(scene, settings, limits);
  REQUIRE(row.shape.uniformSlots == scene.primitives.size());
  CHECK(row.shape.structure == gpu::kStructureNone);
  for (std::uint32_t i = 0; i < row.shape.uniformSlots * gpu::kPrimitiveRows; ++i) {
    CHECK(row.slotRows[i] == row.rows[row.constants.firstPrimitiveRow + i]);
  }
  settings.structure.bvhLayout = render::BvhLayout::cwbvh;
  CHECK(flatten::flattenScene(scene, settings, limits).shape.structure == gpu::kStructureWideBvh);
  // A BVH of one leaf is none, and its primitives are a list again.
  const flatten::FlatScene leaf = flatten::flattenScene(scattered(kSphere, 1), settings, limits);
  CHECK(leaf.shape.layout() == render::LayoutInUse::list);
  CHECK(leaf.shape.firstMarkedSlot == 1);
  settings.structure.bvhLayout = render::BvhLayout::automatic;
  settings.structure.accel = render::AccelKind::grid;
  CHECK(flatten::flattenScene(scene, settings, limits).shape.uniformSlots == 0);
  settings.structure.accel = render::AccelKind::bvh;
  CHECK(flatten::flattenScene(scene, settings).shape.structure ==
        gpu::kStructureWideBvh);  // by the other rule it is not small
}

}  // namespace candela::device
