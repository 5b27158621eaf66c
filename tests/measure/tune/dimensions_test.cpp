// The table of tuned options.
#include "host/measure/tune/dimensions.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/measure/tune/made_rows.h"

namespace candela::tune {
namespace {

TEST_CASE("the first value of every dimension is the built-in one") {
  const render::AutomaticChoices choices = choicesOf(builtIn());
  CHECK(choices.bvhLayout == render::AutomaticChoices{}.bvhLayout);
  CHECK(choices.sceneLoads == render::AutomaticChoices{}.sceneLoads);
  CHECK(extentText(choices.workgroup) == extentText(render::AutomaticChoices{}.workgroup));
  CHECK(choices.kernel == render::AutomaticChoices{}.kernel);
  CHECK(choices.origin == "built-in");
}

TEST_CASE("a candidate is named by its values, and chooses them") {
  const Candidate candidate = candidateWith(
      {{"layout", "bvh2"}, {"loads", "storage"}, {"workgroup", "16x4"}, {"kernel", "wavefront"}});
  CHECK(nameOf(candidate) == "layout=bvh2 loads=storage workgroup=16x4 kernel=wavefront");
  const render::AutomaticChoices choices = choicesOf(candidate);
  CHECK(choices.bvhLayout == render::BvhLayout::bvh2);
  CHECK(choices.sceneLoads == render::SceneLoads::storage);
  CHECK(extentText(choices.workgroup) == "16x4");
  CHECK(choices.kernel == render::KernelKind::wavefront);
}

TEST_CASE("every value of a dimension gives different settings, and is found by its name") {
  for (std::size_t i = 0; i < dimensionTable().size(); ++i) {
    const Dimension& dimension = dimensionTable()[i];
    std::set<std::string> names;
    for (std::size_t value = 0; value < dimension.values.size(); ++value) {
      Candidate candidate = builtIn();
      candidate[i] = value;
      names.insert(nameOf(candidate));
      CHECK(valueNamed(dimension, dimension.values[value].name) == value);
    }
    CHECK(names.size() == dimension.values.size());
    CHECK_FALSE(valueNamed(dimension, "none"));
  }
}

TEST_CASE("workgroups that a device does not support are not feasible on it, and the built-in one always is") {
  vulkan::DeviceInfo least = roomyDevice();  // guaranteed by Vulkan
  least.maxWorkgroupInvocations = 128;
  for (std::uint32_t& side : least.maxWorkgroupSize) side = 128;
  CHECK(isFeasible(builtIn(), least));
  CHECK(isFeasible(candidateWith({{"workgroup", "16x8"}}), least));
  CHECK_FALSE(isFeasible(candidateWith({{"workgroup", "16x16"}}), least));
  CHECK(isFeasible(candidateWith({{"workgroup", "16x16"}}), roomyDevice()));
}

}  // namespace
}  // namespace candela::tune
