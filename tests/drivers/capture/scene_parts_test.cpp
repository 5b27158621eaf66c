// Scenes whose statements or primitives are removed.
#include "host/drivers/capture/scene_parts.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/app/cli/run_program.h"

namespace candela::capture {
namespace {

constexpr const char* kScene =
    "# a scene\n"
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\n"
    "l 1 2 3\n"
    "f 1 0 0 1 0 1 0 1\n"
    "s 0 0 0 1\n"
    "  p 3\n0 0 0\n1 0 0\n0 1 0\n"
    "# between\n"
    "s 3 0 0 1\n";

}  // namespace

TEST_CASE("Statements of primitives and lights can be removed, each with its numbers") {
  const auto parts = statementsOf(kScene, "a.p3f", ".", {});
  REQUIRE(parts->count() == 4);
  CHECK(parts->textWith({0, 1, 2, 3}).size() >= std::string(kScene).size());
  const scene::Scene scene = parts->with({2, 3});
  CHECK(scene.pointLights.empty());
  REQUIRE(scene.primitives.size() == 2);
  CHECK(scene.primitives[0].kind == scene::PrimitiveKind::triangle);
  CHECK(scene.spheres.front().centre.x == 3);
  CHECK(parts->with({0}).pointLights.size() == 1);
  const std::string text = parts->textWith({1});
  CHECK(contains(text, "s 0 0 0 1\n"));
  CHECK(contains(text, "f 1 0 0 1"));
  CHECK(contains(text, "# between\n"));
  CHECK_FALSE(contains(text, "p 3"));
  CHECK_FALSE(contains(text, "0 1 0\n1 0 0"));
}

TEST_CASE("Primitives of a scene of any format can be removed") {
  const auto statements = statementsOf(kScene, "a.p3f", ".", {});
  const scene::Scene scene = statements->with({0, 1, 2, 3});
  const auto parts = primitivesOf(scene);
  REQUIRE(parts->count() == 3);
  const scene::Scene smaller = parts->with({2});
  REQUIRE(smaller.primitives.size() == 1);
  CHECK(smaller.spheres[smaller.primitives[0].index].centre.x == 3);
  CHECK(smaller.pointLights.size() == 1);
  CHECK(parts->textWith({2}).empty());
}

}  // namespace candela::capture
