// Reads the embedded scenes, and generates the others.
#include "host/drivers/conformance/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "embedded/cornell.h"
#include "embedded/depth_of_field.h"
#include "embedded/primitives.h"
#include "host/base/errors.h"
#include "host/drivers/conformance/material_scene.h"
#include "host/formats/load_scene.h"
#include "host/scene/environment/environment.h"
#include "host/scene/generate/kinds.h"

namespace candela::conformance {
namespace {

constexpr std::string_view kMeshKind = "terrain";
constexpr std::uint32_t kMeshSize = 24;

std::string generated(std::string_view kindName, std::uint32_t size) {
  std::string text;
  const auto kinds = generate::kindTable();
  const auto kind = std::ranges::find(kinds, kindName, &generate::Kind::name);
  generate::generateScene(*kind, size, [&](std::string_view part) { text += part; });
  return text;
}

scene::Scene read(const std::string& bytes, const std::string& name) {
  return formats::loadScene(scene::SceneFile{bytes, name, "."}).scene;
}

scene::Scene makeScene(const std::string& name) {
  if (name == "cornell") return read(std::string(embedded::cornell), name);
  if (name == "primitives") return read(std::string(embedded::primitives), name);
  if (name == "depth_of_field") return read(std::string(embedded::depth_of_field), name);
  if (name == kMeshKind) return read(generated(kMeshKind, kMeshSize), name);
  const MaterialScene* const material = materialScene(name);
  if (material == nullptr) throw InternalError(fmt::format("there is no built-in scene {}", name));
  scene::Scene scene = read(textOf(*material), name);
  if (!material->environment.empty()) {
    scene.environment = environment::makeEnvironment({.source = std::string(material->environment)}, scene.up);
  }
  return scene;
}

}  // namespace

const scene::Scene& sceneNamed(const std::string& name) {
  static std::map<std::string, scene::Scene> scenes;
  const auto found = scenes.find(name);
  return found != scenes.end() ? found->second : scenes.emplace(name, makeScene(name)).first->second;
}

}  // namespace candela::conformance
