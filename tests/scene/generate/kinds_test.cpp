// The table of kinds: ranges, limits, scenes that can be loaded.
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <set>

#include "host/formats/loading/diagnostic.h"
#include "tests/scene/generate/generated_text.h"

namespace candela {

TEST_CASE("kinds have different names, a summary, and a default within their sizes") {
  std::set<std::string_view> names;
  for (const generate::Kind& kind : generate::kindTable()) {
    CAPTURE(kind.name);
    CHECK(names.insert(kind.name).second);
    CHECK_FALSE(kind.summary.empty());
    CHECK(kind.minSize <= kind.defaultSize);
    CHECK(kind.defaultSize <= kind.maxSize());
  }
}

TEST_CASE("the maximum size of a kind is the last one within the limit of primitives") {
  for (const generate::Kind& kind : generate::kindTable()) {
    CAPTURE(kind.name);
    if (kind.maxInstances > 0) continue;
    CHECK(kind.primitiveCount(kind.maxSize()) <= generate::kMaxPrimitives);
    CHECK(kind.primitiveCount(kind.maxSize() + 1) > generate::kMaxPrimitives);
  }
  CHECK(kindNamed("balls").maxSize() == 7);
  CHECK(kindNamed("mount").maxSize() == 10);
}

TEST_CASE("the largest scenes of kinds with instances have no more primitives than can be numbered") {
  for (const generate::Kind& kind : generate::kindTable()) {
    if (kind.maxInstances == 0) continue;
    CAPTURE(kind.name);
    CHECK(kind.maxSize() >= 20'000);
    CHECK(kind.primitiveCount(kind.maxSize()) <= std::uint64_t{std::numeric_limits<std::int32_t>::max()});
  }
}

TEST_CASE(
    "every kind's smallest scene loads strictly, with a view and light, and only with the warnings of its colours") {
  // Surfaces of the databases whose shares of light exceed 1.
  const std::map<std::string_view, std::string> expected{{"mount", "Kd + Ks + T = 1.1"},
                                                         {"jacks", "Kd + Ks + T = 1.4"}};
  for (const generate::Kind& kind : generate::kindTable()) {
    CAPTURE(kind.name);
    const scene::LoadedScene loaded = generatedScene(std::string(kind.name), kind.minSize);
    for (const scene::Diagnostic& warning : loaded.warnings) UNSCOPED_INFO(toString(warning));
    CHECK(loaded.scene.camera);
    CHECK(loaded.scene.primitives.size() == kind.primitiveCount(kind.minSize));
    if (generatedText(std::string(kind.name), kind.minSize).starts_with("{")) {  // glTF may use what is not rendered
      for (const scene::Diagnostic& warning : loaded.warnings) {
        CHECK(
            (warning.message.starts_with("not rendered yet") || warning.message.starts_with("transmitting surfaces")));
      }
      continue;
    }
    const auto found = expected.find(kind.name);
    REQUIRE(loaded.warnings.size() == (found == expected.end() ? 0 : 1));
    if (found != expected.end()) CHECK(loaded.warnings[0].message.starts_with(found->second));
  }
}

TEST_CASE("generating a scene again gives the same text") {
  for (const generate::Kind& kind : generate::kindTable()) {
    const std::string name(kind.name);
    CHECK(generatedText(name, kind.minSize) == generatedText(name, kind.minSize));
    CHECK(generatedText(name, kind.minSize) != generatedText(name, kind.minSize + 1));
  }
}

}  // namespace candela
