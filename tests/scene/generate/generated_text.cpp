// The generator and the loader, back to back.
#include "tests/scene/generate/generated_text.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"

namespace candela {

const generate::Kind& kindNamed(const std::string& name) {
  const auto table = generate::kindTable();
  const auto found = std::ranges::find(table, name, &generate::Kind::name);
  REQUIRE(found != table.end());
  return *found;
}

std::string generatedText(const std::string& kind, std::uint32_t size) {
  std::string text;
  generateScene(kindNamed(kind), size, [&](std::string_view block) { text += block; });
  return text;
}

scene::LoadedScene generatedScene(const std::string& kind, std::uint32_t size) {
  const std::string text = generatedText(kind, size);
  const scene::SceneFile file{text, kind, "."};
  return formats::loadScene(file, {});
}

}  // namespace candela
