// Scenes that prefer no acceleration structure get one where brute force would take too long.
#include "host/trace/device/loop_budget.h"

#include <catch2/catch.hpp>

#include "host/trace/vulkan/loop_limit.h"

using namespace candela;
using namespace candela::device;

namespace {

struct Choice {
  render::AccelKind accel;
  std::vector<std::string> warnings;
};

// The choice for a scene of this size that requests no structure, on a device without a loop limit.
Choice choiceFor(std::size_t primitives, bool isPreference) {
  scene::Scene scene;
  scene.primitives.append({scene::PrimitiveKind::sphere, 0, 0}, static_cast<std::uint32_t>(primitives));
  render::StructureSettings structure;
  structure.accel = render::AccelKind::none;
  structure.accelIsPreference = isPreference;
  Choice choice{};
  preferBvh(vulkan::kUnlimitedIterations, {}, scene, 2, structure, choice.warnings);
  choice.accel = structure.accel;
  return choice;
}

constexpr std::size_t kMany = std::size_t{1} << 18;

}  // namespace

TEST_CASE("a file's wish for brute force is followed up to 2^18 primitives on every device") {
  CHECK(choiceFor(kMany, true).accel == render::AccelKind::none);
  CHECK(choiceFor(kMany, true).warnings.empty());
  const Choice choice = choiceFor(kMany + 1, true);
  CHECK(choice.accel == render::AccelKind::bvh);
  REQUIRE(choice.warnings.size() == 1);
  CHECK_THAT(choice.warnings[0], Catch::Contains("262145 primitives: a BVH is used"));
}

TEST_CASE("an option that requests brute force is followed for any number of primitives") {
  CHECK(choiceFor(kMany + 1, false).accel == render::AccelKind::none);
}
