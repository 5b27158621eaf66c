// The comment in which a scene states its exact mean.
#include <catch2/catch.hpp>

#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

TEST_CASE("a scene may state its mean, of the whole image or of a part") {
  CHECK_FALSE(sceneOf("# the exact mean is unknown\ns 0 0 0 1\n").exactMean);
  const auto whole = sceneOf("b 1 1 1\r\n  #exact-mean: .5 1 2e1\r\ns 0 0 0 1\n").exactMean;
  REQUIRE(whole);
  CHECK(whole->rgb == glm::vec3(0.5f, 1, 20));
  CHECK(whole->area == glm::vec4(0, 0, 1, 1));
  const auto part = sceneOf("# exact-mean: 1 1 1 .25 0 .5 1  # the middle\n").exactMean;
  REQUIRE(part);
  CHECK(part->area == glm::vec4(0.25f, 0, 0.5f, 1));
}

TEST_CASE("an exact mean that cannot be parsed is an error with its position") {
  for (const char* numbers :
       {"", " 1 1", " 1 1 1 0", " 1 1 x", " -1 0 0", " 1 1 1 .5 0 .6 1", " 1 1 1 0 0 0 1", " 1 1 nan"}) {
    INFO(numbers);
    const auto errors = errorsOf("b 0 0 0\n# exact-mean:" + std::string(numbers) + "\ns 0 0 0 1\n");
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].line == 2);
    CHECK(errors[0].column == 14);
    CHECK(contains(errors[0].message, "exact-mean: r g b [x y width height]"));
  }
}

}  // namespace
}  // namespace candela::scene
