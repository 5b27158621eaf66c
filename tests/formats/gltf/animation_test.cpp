// The first animation at a time: interpolation by hand.
#include "host/formats/gltf/animation.h"

#include <numbers>

#include "host/scene/same_scene.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

/// A triangle whose node is animated by one channel with key frames at 1 and 3 seconds.
GltfFile animated(const char* path, const std::vector<float>& output, const char* type, std::size_t components,
                  const char* interpolation) {
  GltfFile file = triangleFile();
  const std::size_t times = file.vectors({1, 3}, "SCALAR", 1);
  const std::size_t values = file.vectors(output, type, components);
  file.root["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
       {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}}}};
  return file;
}

glm::vec3 originAt(const GltfFile& file, std::optional<double> seconds) {
  return sceneOf(file, {.time = seconds}).meshes.at(0).positions.at(0);
}

}  // namespace

TEST_CASE("translations are interpolated between key frames and held outside them") {
  const GltfFile linear = animated("translation", {0, 0, 2, 8, 0, 2}, "VEC3", 3, "LINEAR");
  CHECK(originAt(linear, std::nullopt) == glm::vec3(0));
  CHECK(originAt(linear, 0) == glm::vec3(0, 0, 2));
  CHECK(originAt(linear, 1.5) == glm::vec3(2, 0, 2));
  CHECK(originAt(linear, 99) == glm::vec3(8, 0, 2));
  const GltfFile step = animated("translation", {0, 0, 2, 8, 0, 2}, "VEC3", 3, "STEP");
  CHECK(originAt(step, 2.9) == glm::vec3(0, 0, 2));
  CHECK(originAt(step, 3) == glm::vec3(8, 0, 2));
}

TEST_CASE("cubic splines have tangents, which count by the length of the interval") {
  // In-tangent, value, out-tangent of each frame. At the middle: (v0 + v1)/2 + duration (out0 - in1)/8.
  const GltfFile file = animated("translation", {9, 9, 9, 0, 0, 0, 4, 0, 0, 0, 4, 0, 8, 0, 0, 9, 9, 9}, "VEC3", 3,
                                 "CUBICSPLINE");
  CHECK(originAt(file, 1) == glm::vec3(0));
  CHECK(originAt(file, 2) == glm::vec3(4 + 1, -1, 0));
  CHECK(originAt(file, 3) == glm::vec3(8, 0, 0));
}

TEST_CASE("rotations are interpolated on the sphere, along the shorter way") {
  const float a = std::sqrt(0.5f);
  const GltfFile file = animated("rotation", {0, 0, 0, 1, 0, 0, -a, -a}, "VEC4", 4, "LINEAR");
  const glm::vec3 x = sceneOf(file, {.time = 2}).meshes.at(0).positions.at(1);
  CHECK(glm::distance(x, glm::vec3(a, a, 0)) < 1e-6f);  // half of 90 degrees
  const float quarter = glm::radians(22.5f);            // where the chord between the quaternions would be 21.6 degrees
  const glm::vec3 sooner = sceneOf(file, {.time = 1.5}).meshes.at(0).positions.at(1);
  CHECK(glm::distance(sooner, glm::vec3(std::cos(quarter), std::sin(quarter), 0)) < 1e-6f);
}

TEST_CASE("an animation is chosen by its name, else by its index, and the first one by default") {
  GltfFile file = animated("translation", {1, 0, 0, 1, 0, 0}, "VEC3", 3, "STEP");
  nlohmann::json other = file.root["animations"][0];
  other["samplers"][0]["output"] = file.vectors({2, 0, 0, 2, 0, 0}, "VEC3", 3);
  other["name"] = "Walk";
  file.root["animations"].push_back(other);
  other["samplers"][0]["output"] = file.vectors({3, 0, 0, 3, 0, 0}, "VEC3", 3);
  other["name"] = "0";
  file.root["animations"].push_back(other);
  const auto x = [&](const std::optional<std::string>& animation) {
    return sceneOf(file, {.time = 1, .animation = animation}).meshes.at(0).positions.at(0).x;
  };
  CHECK(x(std::nullopt) == 1);
  CHECK(x("Walk") == 2);
  CHECK(x("1") == 2);
  CHECK(x("0") == 3);
  CHECK_THROWS_WITH(x("Run"),
                    Catch::Contains("no animation \"Run\"; the file has the animations 0, 1 \"Walk\", 2 \"0\""));
  CHECK(sceneOf(file, {.time = 1}).hash != sceneOf(file, {.time = 1, .animation = "Walk"}).hash);
}

/// The file of animated(), whose channel sets the property at a JSON pointer instead.
GltfFile pointed(const std::string& pointer, const std::vector<float>& output, const char* type, std::size_t components,
                 const char* interpolation = "LINEAR") {
  GltfFile file = animated("pointer", output, type, components, interpolation);
  nlohmann::json& target = file.root["animations"][0]["channels"][0]["target"];
  target.erase("node");
  target["extensions"]["KHR_animation_pointer"]["pointer"] = pointer;
  file.root["extensionsUsed"] = {"KHR_animation_pointer"};
  file.root["materials"] = {{{"pbrMetallicRoughness", {{"roughnessFactor", 0.25}}}}, nlohmann::json::object()};
  file.root["meshes"][0]["primitives"][0]["material"] = 0;
  return file;
}

TEST_CASE("KHR_animation_pointer changes materials, lights, cameras and nodes") {
  const GltfFile emission = pointed("/materials/0/emissiveFactor", {0, 0, 0, 8, 4, 2}, "VEC3", 3);
  CHECK(sceneOf(emission, {}).materials[0].emission == glm::vec3(0));
  CHECK(sceneOf(emission, {.time = 1.5}).materials[0].emission == glm::vec3(2, 1, 0.5f));
  const GltfFile moved = pointed("/nodes/0/translation", {0, 0, 0, 8, 0, 0}, "VEC3", 3);
  CHECK(originAt(moved, 2) == glm::vec3(4, 0, 0));
  GltfFile lamp = pointed("/extensions/KHR_lights_punctual/lights/0/intensity", {0, 40}, "SCALAR", 1);
  lamp.root["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  lamp.root["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  CHECK(sceneOf(lamp, {.time = 2}).punctualLights.at(0).intensity == glm::vec3(20));
  GltfFile zoom = pointed("/cameras/0/perspective/yfov", {0.5, 1.5}, "SCALAR", 1);
  zoom.root["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}}};
  zoom.root["nodes"][0]["camera"] = 0;
  CHECK(sceneOf(zoom, {.time = 2}).camera->angle == static_cast<float>(180 / std::numbers::pi));
}

TEST_CASE("KHR_animation_pointer sets a property that the file leaves at its default, but invents no extension") {
  const GltfFile metal = pointed("/materials/1/pbrMetallicRoughness/metallicFactor", {0, 1}, "SCALAR", 1);
  CHECK(sceneOf(metal, {}).materials[1].surface->metalness == 1);
  CHECK(sceneOf(metal, {.time = 1.5}).materials[1].surface->metalness == 0.25f);
  const GltfFile sheen = pointed("/materials/0/extensions/KHR_materials_sheen/sheenRoughnessFactor", {0, 1}, "SCALAR",
                                 1);
  CHECK_THROWS_WITH(sceneOf(sheen, {.time = 2}),
                    Catch::Contains("no object /materials/0/extensions/KHR_materials_sheen that"));
  CHECK_NOTHROW(sceneOf(sheen, {}));
}

TEST_CASE("values of splines beyond the range of a property are clamped") {
  // Overshoots: at the middle, (1 + 1)/2 + 2 (4 - 0)/8 = 2.
  const GltfFile file = pointed("/materials/0/emissiveFactor", {0, 0, 0, 1, 1, 1, -4, 4, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0},
                                "VEC3", 3, "CUBICSPLINE");
  CHECK(sceneOf(file, {.time = 2}).materials[0].emission == glm::vec3(0, 2, 1));
  const GltfFile metal = pointed("/materials/0/pbrMetallicRoughness/metallicFactor", {0, 1, 9, 0, 1, 0}, "SCALAR", 1,
                                 "CUBICSPLINE");
  CHECK(sceneOf(metal, {.time = 2}).materials[0].surface->metalness == 1);
}

TEST_CASE("visibility is animated by steps") {
  GltfFile file = pointed("/nodes/0/extensions/KHR_node_visibility/visible", {1, 0}, "SCALAR", 1, "STEP");
  file.root["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = true;
  CHECK(sceneOf(file, {.time = 1}).primitives.size() == 1);
  CHECK(sceneOf(file, {.time = 3}).primitives.empty());
}

TEST_CASE("pointers to what no animation may change are refused") {
  for (const char* pointer :
       {"", "x", "/", "/nodes/0/mesh", "/accessors/0/count", "/animations/0/name", "/asset/version",
        "/materials/0/name", "/materials/~2/extensions/KHR_texture_transform/offset",
        "/materials/0/pbrMetallicRoughness/baseColorFactor/0"}) {
    CAPTURE(pointer);
    CHECK_THROWS_WITH(sceneOf(pointed(pointer, {0, 1}, "SCALAR", 1), {.time = 2}),
                      Catch::Contains("is not a property that an animation may change"));
  }
  for (const char* pointer : {"/materials/9/alphaCutoff", "/materials/99999999999999999999/alphaCutoff",
                              "/materials/00/alphaCutoff", "/cameras/0/perspective/yfov"}) {
    CAPTURE(pointer);
    CHECK_THROWS_AS(sceneOf(pointed(pointer, {0, 1}, "SCALAR", 1), {.time = 2}), scene::SceneError);
  }
  CHECK_THROWS_WITH(sceneOf(pointed("/materials/0/alphaCutoff", {0, 0, 1, 1}, "SCALAR", 1), {.time = 2}),
                    Catch::Contains("more numbers than the property"));
  CHECK_THROWS_WITH(sceneOf(pointed("/materials/0/emissiveFactor", {0, 1}, "SCALAR", 1), {.time = 2}),
                    Catch::Contains("1 components instead of 3"));
}

TEST_CASE("weights of morph targets are animated") {
  GltfFile file = animated("weights", {0, 0, 1, 0.5f}, "SCALAR", 1, "LINEAR");
  file.primitive()["targets"] = {{{"POSITION", file.positions({4, 0, 0, 0, 0, 0, 0, 0, 0})}},
                                 {{"POSITION", file.positions({0, 8, 0, 0, 0, 0, 0, 0, 0})}}};
  CHECK(originAt(file, 2) == glm::vec3(2, 2, 0));
}

TEST_CASE("a time without an animation causes a warning") {
  CHECK(warns(load(triangleFile(), {.time = 1}), "time has no effect: the file has no animation"));
  CHECK_FALSE(warns(load(triangleFile()), "time has"));
  CHECK_FALSE(warns(load(animated("translation", {0, 0, 2, 8, 0, 2}, "VEC3", 3, "LINEAR"), {.time = 1}), "time has"));
}

TEST_CASE("an animated node has no matrix, and channels without a node are skipped") {
  GltfFile file = animated("translation", {0, 0, 2, 8, 0, 2}, "VEC3", 3, "LINEAR");
  file.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  CHECK(errorsOf(file.text()).empty());
  CHECK(errorsOf(file.text(), {.time = 1}).find("/nodes/0/matrix: an animated node") != std::string::npos);
  file.root["animations"][0]["channels"][0]["target"].erase("node");
  CHECK(errorsOf(file.text(), {.time = 1}).empty());
  GltfFile byPointer = pointed("/nodes/0/translation", {0, 0, 0, 8, 0, 0}, "VEC3", 3);
  byPointer.root["nodes"][0]["matrix"] = file.root["nodes"][0]["matrix"];
  CHECK(errorsOf(byPointer.text(), {.time = 1}).find("an animated node has a matrix") != std::string::npos);
}

TEST_CASE("a file that is read once gives the scenes of single readings, in any order") {
  GltfFile file = animated("translation", {0, 0, 0, 8, 0, 0}, "VEC3", 3, "LINEAR");
  const std::string text = file.text();
  const scene::SceneFile source{text, "test.gltf", "."};
  const auto reader = gltfLoader().open(source, {}, true);
  for (const std::optional<double> time : {std::optional<double>(2), {}, {3}, {2}, {0.5}}) {
    const scene::LoadedScene often = reader->at(time);
    const scene::LoadedScene once = gltfLoader().open(source, {}, false)->at(time);
    CHECK(often.scene.hash == once.scene.hash);
    CHECK(often.scene.camera == once.scene.camera);
    CHECK(scene::differOnlyInCamera(often.scene, once.scene));
    CHECK(often.animationEnd == 3.0);
  }
}

TEST_CASE("the view that frames a moving model and the default light do not move") {
  const GltfFile file = animated("translation", {0, 0, 0, 8, 0, 0}, "VEC3", 3, "LINEAR");
  const scene::Scene first = sceneOf(file, {.time = 1}), last = sceneOf(file, {.time = 3});
  CHECK(first.camera == last.camera);
  REQUIRE(first.punctualLights.size() == 1);
  CHECK(first.punctualLights[0].direction == last.punctualLights[0].direction);
  CHECK(first.camera->at.x == Approx(4.5));  // the middle of 0 to 9
  CHECK(sceneOf(file, {}).camera->at.x == Approx(0.5));
}

TEST_CASE("a light that an animation switches on does not remove the default light") {
  GltfFile file = animated("translation", {0, 0, 0, 0, 0, 0}, "VEC3", 3, "LINEAR");
  file.root["extensionsUsed"] = {"KHR_animation_pointer"};
  file.root["materials"] = json::array({json{{"emissiveFactor", {0, 0, 0}}}});
  file.primitive()["material"] = 0;
  file.root["animations"][0]["channels"][0]["target"] = {
      {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/materials/0/emissiveFactor"}}}}}};
  const std::size_t values = file.vectors({0, 0, 0, 1, 1, 1}, "VEC3", 3);
  file.root["animations"][0]["samplers"][0]["output"] = values;
  const scene::Scene dark = sceneOf(file, {.time = 1}), bright = sceneOf(file, {.time = 3});
  CHECK(dark.materials[0].emission == glm::vec3(0));
  CHECK(bright.materials[0].emission == glm::vec3(1));
  CHECK(dark.punctualLights.size() == 1);
  CHECK(bright.punctualLights == dark.punctualLights);
}

}  // namespace candela::gltf
