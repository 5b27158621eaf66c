// Rays alone find the same hits through every layout of a tree, however it is read, and by brute force.
#include "host/render/ray_caster.h"

#include <array>
#include <catch2/catch.hpp>
#include <optional>

#include "tests/render/render_support.h"
#include "tests/vulkan_support/test_device.h"

using namespace candela;

namespace {

struct Layout {
  AccelKind accel;
  BvhLayout layout;
  SceneLoads loads;
};

using Words = std::vector<std::array<std::uint32_t, 2>>;

// Distance and primitive of each ray's hit; of shadow rays whether they are blocked.
Words wordsOf(RayCaster& caster, const RaySets& sets, std::uint32_t kind) {
  caster.load(sets[kind], kind == gpu::kShadowRay);
  caster.trace();
  Words words;
  for (const gpu::CastHit& hit : caster.hits()) words.push_back({hit.found.x, hit.found.y});
  return words;
}

}  // namespace

TEST_CASE("rays alone find the same hits through every layout, however it is read, and by brute force") {
  vulkan::Device device = openTestDevice();
  // Of the second scene most rays miss.
  const Scene scene = GENERATE(true, false) ? loadTestScene("primitives.p3f") : loadSpdScene("balls_2.nff");
  RenderSettings settings = squareSettings(48, 1);
  std::optional<RaySets> sets;
  std::array<Words, gpu::kRayKindCount> expected;
  for (const Layout& layout : {Layout{AccelKind::none, BvhLayout::automatic, SceneLoads::storage},
                               Layout{AccelKind::bvh, BvhLayout::cwbvh, SceneLoads::texel},
                               Layout{AccelKind::bvh, BvhLayout::cwbvh, SceneLoads::storage}}) {
    settings.accel = layout.accel;
    settings.bvhLayout = layout.layout;
    settings.sceneLoads = layout.loads;
    RayCaster caster(device, flatten(scene, settings), settings);
    if (!sets) sets = caster.makeRays();
    REQUIRE((*sets)[gpu::kPrimaryRay].size() == 48 * 48);
    for (std::uint32_t kind = 0; kind < gpu::kRayKindCount; ++kind) {
      REQUIRE((*sets)[kind].size() > 100);
      const Words found = wordsOf(caster, *sets, kind);
      if (expected[kind].empty()) expected[kind] = found;
      CHECK(found == expected[kind]);
    }
  }
  std::size_t blocked = 0;
  for (const auto& word : expected[gpu::kShadowRay]) blocked += word[1];
  CHECK(blocked > 0);
  CHECK(blocked < expected[gpu::kShadowRay].size());
}
