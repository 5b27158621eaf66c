// Reads the embedded scenes, and generates the others.
#include "host/drivers/conformance/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "embedded/cornell.h"
#include "embedded/depth_of_field.h"
#include "embedded/primitives.h"
#include "host/base/errors.h"
#include "host/formats/load_scene.h"
#include "host/scene/environment/environment.h"
#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/kinds.h"
#include "host/scene/generate/lathe.h"

namespace candela::conformance {
namespace {

void keepScene(scene::Scene&) {}

struct MaterialScene {
  std::string_view name;
  generate::MaterialFactors factors{};
  std::string_view floorTexture = {};         ///< the member of the floor's material that is an image; empty: none
  void (*change)(scene::Scene&) = keepScene;  ///< makes what glTF does not state
};

// The material of the ball, and that of the floor.
constexpr std::size_t kBall = 0, kFloor = 1;

constexpr std::string_view kNormalTexture = "normalTexture";
constexpr std::uint32_t kRings = 8;
constexpr double kRadius = 1;
constexpr std::uint32_t kTextureSide = 8;

void lightBySun(scene::Scene& scene) {
  scene.environment = environment::makeEnvironment({.source = "sun:35,20,3"}, scene.up);
}

scene::Material materialOf(const scene::SurfaceParameters& surface) {
  scene::Material material;
  material.surface = surface;
  return material;
}

scene::Material roughPlastic() {
  constexpr float kRoughness = 0.5f, kIor = 1.5f;
  return materialOf({.baseColour = {0.7f, 0.2f, 0.1f},
                     .roughness = kRoughness,
                     .ior = kIor,
                     .plastic = scene::makePlastic(scene::Interface::ggx, kRoughness, kIor, true)});
}

scene::Material roughConductor() {
  return materialOf({.metalness = 1,
                     .roughness = 0.5f,
                     .conductor = scene::Conductor{{0.2f, 0.92f, 1.1f}, {3.91f, 2.45f, 2.14f}},
                     .bareInterface = scene::Interface::beckmann});
}

// Rays choose it or the plastic in equal parts.
void chooseMaterials(scene::Scene& scene) {
  const auto first = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.insert(scene.materials.end(), {roughPlastic(), roughConductor()});
  scene::Material either;
  either.choice = scene::MaterialChoice{first, first + 1, 0.5f};
  scene.materials[kBall] = either;
}

void makeBumps(scene::Scene& scene) {
  scene::Material& floor = scene.materials[kFloor];
  floor.normalScale = 0.4f;
  floor.hasHeights = true;
  floor.hasFacets = false;
}

const std::array<MaterialScene, 16>& materialTable() {
  static const std::array<MaterialScene, 16> table{{
      {.name = "plastic", .factors = {.colour = {0.75, 0.1, 0.1}, .roughness = 0.4}},
      {.name = "metal", .factors = {.colour = {1, 0.77, 0.34}, .metalness = 1, .roughness = 0.3}},
      {.name = "conductor",
       .factors = {.metalness = 1, .roughness = 0.2, .eta = {0.143, 0.375, 1.442}, .kappa = {3.983, 2.386, 1.603}}},
      {.name = "thin_wall", .factors = {.colour = {0.3, 0.6, 0.9}, .roughness = 0.2, .transmission = 0.8}},
      {.name = "absorbing_glass",
       .factors = {.roughness = 0.1,
                   .transmission = 1,
                   .thickness = 2,
                   .attenuation = {0.5, 0.9, 0.7},
                   .attenuationDistance = 1}},
      {.name = "dispersion",
       .factors = {.roughness = 0.1, .transmission = 1, .ior = 1.8, .thickness = 2, .dispersion = 2}},
      {.name = "coat",
       .factors = {.colour = {0.1, 0.2, 0.6}, .roughness = 0.6, .clearcoat = 1, .clearcoatRoughness = 0.1}},
      {.name = "sheen",
       .factors = {.colour = {0.05, 0.08, 0.2}, .roughness = 0.7, .sheen = {0.8, 0.7, 0.9}, .sheenRoughness = 0.4}},
      {.name = "thin_film",
       .factors = {.colour = {0.03, 0.03, 0.03}, .roughness = 0.2, .film = 1, .filmThickness = 550}},
      {.name = "texture", .factors = {.colour = {0.8, 0.8, 0.8}}, .floorTexture = "baseColorTexture"},
      {.name = "environment", .factors = {.colour = {0.8, 0.7, 0.6}, .roughness = 0.5}, .change = lightBySun},
      {.name = "rough_plastic", .change = [](scene::Scene& scene) { scene.materials[kBall] = roughPlastic(); }},
      {.name = "rough_dielectric",
       .change =
           [](scene::Scene& scene) {
             scene.materials[kBall] = materialOf({.roughness = 0.5f,
                                                  .ior = 1.5f,
                                                  .transmissionWeight = 1,
                                                  .isThinWalled = false,
                                                  .bareInterface = scene::Interface::ggx});
           }},
      {.name = "rough_conductor", .change = [](scene::Scene& scene) { scene.materials[kBall] = roughConductor(); }},
      {.name = "choice", .change = chooseMaterials},
      {.name = "bump_map", .floorTexture = kNormalTexture, .change = makeBumps},
  }};
  return table;
}

// A coarse pattern without symmetry.
std::vector<std::byte> texturePixels() {
  std::vector<std::byte> pixels;
  for (std::uint32_t i = 0; i < kTextureSide * kTextureSide * 3; ++i)
    pixels.push_back(std::byte(40 + (i * 37 + i / 24 * 91) % 200));
  return pixels;
}

/// Returns the scene, or null if there is none of this name.
const MaterialScene* materialScene(std::string_view name) {
  const auto found = std::ranges::find(materialTable(), name, &MaterialScene::name);
  return found == materialTable().end() ? nullptr : &*found;
}

/// Returns the file: a ball of the material on a floor.
std::string textOf(const MaterialScene& scene) {
  generate::GltfDocument document;
  const std::size_t ball = document.addShape(generate::lathe(generate::sphereProfile(kRadius, kRings), 2 * kRings));
  const std::size_t floor = document.addShape(generate::square(4, 3));
  generate::GltfDocument::Json floorMaterial = generate::gltfMaterial({.colour = {0.6, 0.6, 0.55}, .roughness = 1});
  if (const std::string_view member = scene.floorTexture; !member.empty()) {
    const std::size_t texture = document.addTexture(kTextureSide, kTextureSide, texturePixels());
    (member == kNormalTexture ? floorMaterial : floorMaterial["pbrMetallicRoughness"])[member] = {{"index", texture}};
  }
  document.addNode(ball, document.addMaterial(generate::gltfMaterial(scene.factors)), {0, kRadius, 0});
  document.addNode(floor, document.addMaterial(floorMaterial), {0, 0, 0});
  document.addCamera({0, 2.4, 4.5}, {0, 0.9, 0}, 40, 1);
  return document.text();
}

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
  material->change(scene);
  return scene;
}

}  // namespace

std::vector<std::string_view> materialNames() {
  std::vector<std::string_view> names;
  for (const MaterialScene& scene : materialTable()) names.push_back(scene.name);
  return names;
}

const scene::Scene& sceneNamed(const std::string& name) {
  static std::map<std::string, scene::Scene> scenes;
  const auto found = scenes.find(name);
  return found != scenes.end() ? found->second : scenes.emplace(name, makeScene(name)).first->second;
}

}  // namespace candela::conformance
