// Rays have the same hits with every layout of a BVH and every buffer type, and by brute force.
#include "host/trace/device/ray_caster.h"

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <optional>

#include "tests/formats/loading/triangles.h"
#include "tests/scene/generate/generated_text.h"
#include "tests/trace/device/cast_words.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

struct Layout {
  render::AccelKind accel;
  render::BvhLayout layout;
  render::SceneLoads loads;
};

scene::Scene scaledTriangles(scene::Scene scene, float factor) {
  for (scene::Mesh& mesh : scene.meshes) {
    for (glm::vec3& position : mesh.positions) position *= factor;
  }
  return scene;
}

std::vector<gpu::CastRay> scaledRays(std::vector<gpu::CastRay> rays, float factor) {
  for (gpu::CastRay& ray : rays) ray.originLimit *= factor;
  return rays;
}

}  // namespace

TEST_CASE("rays alone have the same hits with every layout and buffer type, and by brute force") {
  vulkan::Device device = openTestDevice();
  // Most rays miss the second scene.
  const scene::Scene scene = GENERATE(true, false) ? loadTestScene("primitives.p3f") : loadSpdScene("balls_2.nff");
  render::RenderSettings settings = squareSettings(48, 1);
  std::optional<RaySets> sets;
  std::array<CastWords, gpu::kRayKindCount> expected;
  for (const Layout& layout :
       {Layout{render::AccelKind::none, render::BvhLayout::automatic, render::SceneLoads::storage},
        Layout{render::AccelKind::bvh, render::BvhLayout::cwbvh, render::SceneLoads::texel},
        Layout{render::AccelKind::bvh, render::BvhLayout::cwbvh, render::SceneLoads::storage}}) {
    settings.structure.accel = layout.accel;
    settings.structure.bvhLayout = layout.layout;
    settings.execution.sceneLoads = layout.loads;
    RayCaster caster(device, flatten::flattenScene(scene, settings), settings);
    if (!sets) sets = caster.makeRays();
    REQUIRE((*sets)[gpu::kPrimaryRay].size() == 48 * 48);
    for (std::uint32_t kind = 0; kind < gpu::kRayKindCount; ++kind) {
      REQUIRE((*sets)[kind].size() > 100);
      const CastWords found = castWords(caster, (*sets)[kind], kind == gpu::kShadowRay);
      if (expected[kind].empty()) expected[kind] = found;
      CHECK(found == expected[kind]);
    }
  }
  std::size_t blocked = 0;
  for (const auto& word : expected[gpu::kShadowRay]) blocked += word[1];
  CHECK(blocked > 0);
  CHECK(blocked < expected[gpu::kShadowRay].size());
}

TEST_CASE("a terrain scaled into a unit cube has the same hits") {
  vulkan::Device device = openTestDevice();
  const float factor = 0x1p-7f;  // the terrain's side is 100: no rounding, so that hits agree to the last bit
  const scene::Scene scene = generatedScene("terrain", 40).scene;
  REQUIRE(scene.primitives.size() == trianglesOf(scene).size());
  render::RenderSettings settings = squareSettings(64, 1);
  settings.structure.bvhLayout = GENERATE(render::BvhLayout::bvh2, render::BvhLayout::cwbvh);
  RayCaster large(device, flatten::flattenScene(scene, settings), settings);
  RayCaster small(device, flatten::flattenScene(scaledTriangles(scene, factor), settings), settings);
  const RaySets sets = large.makeRays();
  for (const std::uint32_t kind : {gpu::kPrimaryRay, gpu::kDiffuseRay}) {
    REQUIRE(sets[kind].size() > 1000);
    large.load(sets[kind], false);
    small.load(scaledRays(sets[kind], factor), false);
    large.trace();
    small.trace();
    const std::vector<gpu::CastHit> expected = large.hits(), found = small.hits();
    std::size_t met = 0, differing = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const bool meets = expected[i].found.y != gpu::kNoPrimitive;
      const float distance = std::bit_cast<float>(expected[i].found.x);
      met += meets;
      differing += found[i].found.y != expected[i].found.y ||
                   (meets && std::bit_cast<float>(found[i].found.x) != factor * distance);
    }
    CHECK(met > 100);
    CHECK(differing == 0);
  }
}
