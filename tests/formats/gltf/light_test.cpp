// KHR_lights_punctual, and the light that a file without any gets.
#include "host/image/codecs.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

GltfFile withLight(const json& light, const json& node) {
  GltfFile file = triangleFile();
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({light});
  json placed = node;
  placed["extensions"]["KHR_lights_punctual"]["light"] = 0;
  file.addNode(placed);
  return file;
}

/// Two crossing triangles with a box of 4 x 4 x 3, beside a square metre at the height of 3 that emits by a texture of
/// `texels`, at the centre of the first one where `u` is 0 and at that of the last one where it is 1.
GltfFile roomWithTexturedLamp(const std::vector<std::uint8_t>& texels, double strength, float u) {
  GltfFile file;
  const image::Pixels8 pixels{static_cast<std::uint32_t>(texels.size() / 3), 1, texels};
  file.root["images"] = {{{"bufferView", file.view(image::toPng(pixels))}, {"mimeType", "image/png"}}};
  file.root["samplers"] = {{{"wrapS", 33071}}};
  file.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
  file.root["materials"] = {{{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}}};
  file.root["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
  const std::size_t walls = file.positions({0, 0, 0, 4, 0, 0, 4, 4, 3, 0, 0, 0, 0, 4, 0, 4, 4, 3});
  const std::size_t lamp = file.positions({1, 1, 3, 2, 1, 3, 2, 2, 3, 1, 1, 3, 2, 2, 3, 1, 2, 3});
  const std::size_t places = file.vectors(std::vector<float>{u, 0, u, 0, u, 0, u, 0, u, 0, u, 0}, "VEC2", 2);
  file.addMesh({{"attributes", {{"POSITION", walls}}}});
  file.addMesh({{"attributes", {{"POSITION", lamp}, {"TEXCOORD_0", places}}}, {"material", 0}});
  return file;
}

}  // namespace

TEST_CASE("a point light has the place of its node, and colour times intensity") {
  const scene::LoadedScene loaded = load(withLight(
      {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}, {"range", 3}}, {{"translation", {1, 2, 3}}}));
  REQUIRE(loaded.scene.punctualLights.size() == 1);
  const scene::PunctualLight& light = loaded.scene.punctualLights[0];
  CHECK(light.kind == scene::PunctualLight::Kind::point);
  CHECK(light.position == glm::vec3(1, 2, 3));
  CHECK(light.intensity == glm::vec3(40, 20, 0));
  CHECK(loaded.scene.background == glm::vec3(0));
  CHECK(warns(loaded, "/extensions/KHR_lights_punctual/lights/0/range is ignored"));
}

TEST_CASE("spot and directional lights shine along -z of their node") {
  const double a = std::sqrt(0.5);
  const json turned{{"rotation", {0, a, 0, a}}, {"scale", {2, 2, 2}}};
  const scene::Scene spot = sceneOf(
      withLight({{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 1.0}}}}, turned));
  const scene::PunctualLight& light = spot.punctualLights.at(0);
  CHECK(glm::distance(light.direction, glm::vec3(-1, 0, 0)) < 1e-6f);
  CHECK(light.versineInner == Approx(1 - std::cos(0.5)));
  CHECK(light.versineOuter == Approx(1 - std::cos(1.0)));
  const scene::Scene sun = sceneOf(withLight({{"type", "directional"}, {"intensity", 3}}, turned));
  CHECK(sun.punctualLights.at(0).kind == scene::PunctualLight::Kind::directional);
  CHECK(sun.punctualLights[0].reach == Approx(std::sqrt(0.5)));  // half the diagonal of the triangle's box
}

TEST_CASE("the angles of a narrow spot light keep their precision") {
  const scene::Scene spot = sceneOf(
      withLight({{"type", "spot"}, {"spot", {{"innerConeAngle", 1e-4}, {"outerConeAngle", 2e-4}}}}, json::object()));
  // 1 - cos x = x^2/2 - x^4/24 + ...
  CHECK(spot.punctualLights.at(0).versineInner == Approx(0.5e-8).epsilon(1e-6));
  CHECK(spot.punctualLights.at(0).versineOuter == Approx(2e-8).epsilon(1e-6));
}

TEST_CASE("a spot light of half a turn is read, although pi/2 in single precision exceeds pi/2") {
  const GltfFile file = withLight(
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 1.5707963705062866}}}}, json::object());
  CHECK(sceneOf(file).punctualLights.at(0).versineOuter == 1);
  CHECK_FALSE(warns(load(file), "hard"));
}

TEST_CASE("a spot light whose inner cone is not inside the outer one has a hard edge, and a warning says so") {
  for (const double inner : {0.5, 0.75}) {
    const scene::LoadedScene loaded = load(
        withLight({{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", 0.5}}}}, json::object()));
    const scene::PunctualLight& light = loaded.scene.punctualLights.at(0);
    CHECK(light.versineOuter == Approx(1 - std::cos(0.5)));
    CHECK(light.versineInner == std::nextafter(light.versineOuter, 0.0f));
    CHECK(warns(loaded, "/extensions/KHR_lights_punctual/lights/0/spot: the inner cone is not inside the outer one"));
  }
}

TEST_CASE("angles of a spot light outside of their range are refused") {
  const std::pair<double, double> angles[] = {{-0.1, 0.5}, {0.1, 1.571}, {0, 0}, {0, -1}, {0, 1e-7}};
  for (const auto& [inner, outer] : angles) {
    CAPTURE(inner, outer);
    const json spot{{"innerConeAngle", inner}, {"outerConeAngle", outer}};
    const std::string errors = errorsOf(withLight({{"type", "spot"}, {"spot", spot}}, json::object()).text());
    CHECK(errors.find("the angles of the cones are not inner >= 0 and 1e-6 <= outer <= pi/2") != std::string::npos);
  }
}

TEST_CASE("a file without light gets one, and says so, and an emitter is a light") {
  const scene::LoadedScene dark = load(triangleFile());
  CHECK(dark.scene.background == glm::vec3(0.25f));
  CHECK(dark.scene.punctualLights.size() == 1);
  CHECK(dark.facts.at(1).second.starts_with("none in the file"));
  GltfFile bright = triangleFile();
  bright.root["materials"] = {{{"emissiveFactor", {0, 1, 0}}}};
  bright.primitive()["material"] = 0;
  CHECK(load(bright).facts.at(1).second == "as in the file");
  CHECK(sceneOf(bright).punctualLights.empty());
}

TEST_CASE("a warning says that the light of punctual lights and of the default light does not pass glass") {
  const auto warned = [](const GltfFile& file, const scene::LoadOptions& options = {}) {
    return warns(load(file, options), "transmitting surfaces cast shadows of point, spot and directional lights");
  };
  GltfFile glass = withLight({{"type", "point"}}, json::object());
  CHECK_FALSE(warned(glass));
  glass.root["materials"] = {{{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 0.5}}}}}}};
  CHECK_FALSE(warned(glass));  // no triangle has the material
  glass.primitive()["material"] = 0;
  glass.root["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 0;
  CHECK(warned(glass));
  GltfFile dark = triangleFile();
  dark.root["materials"] = glass.root["materials"];
  dark.primitive()["material"] = 0;
  CHECK(warned(dark));
  scene::LoadOptions white;
  white.environment.source = "white";
  CHECK_FALSE(warned(dark, white));
  glass.root["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 1;
  CHECK_FALSE(warned(glass));
}

TEST_CASE("emission of unlit and of invisible surfaces is not the light of a file") {
  GltfFile file = triangleFile();
  file.root["materials"] = {{{"emissiveFactor", {0, 1, 0}}}};
  file.primitive()["material"] = 0;
  json& material = file.root["materials"][0];
  SECTION("unlit") { material = {{"extensions", {{"KHR_materials_unlit", json::object()}}}}; }
  SECTION("with an alpha of 0") {
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
  }
  CHECK(load(file).facts.at(1).second.starts_with("none in the file: a background of 0.25"));
}

TEST_CASE("emission that is too faint or too small to see the model by does not replace the default light") {
  GltfFile file = triangleFile();
  file.root["materials"] = {{{"emissiveFactor", {0, 1, 0}}}};
  const std::size_t small = file.positions({0, 0, 0, 0.1f, 0, 0, 0, 0.1f, 0});
  const auto lightWith = [&](double strength) {
    file.root["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
    return load(file).facts.at(1).second;
  };
  file.addMesh({{"attributes", {{"POSITION", small}}}, {"material", 0}});
  // The radius is sqrt(1/2), so that the mean radiance is 0.005 strength / (2 pi): 0.02 at 25.13.
  CHECK(lightWith(25.1).starts_with("too faint in the file: a background of 0.25"));
  CHECK(lightWith(25.2) == "as in the file");
}

TEST_CASE("a room that a textured lamp lights gets no default light, and a model with a decorative display does") {
  const auto lightOf = [](const std::vector<std::uint8_t>& texels, double strength, float u) {
    return load(roomWithTexturedLamp(texels, strength, u)).facts.at(1).second;
  };
  // The squared diagonal is 41 and a fifth of the emission counts: 0.2 strength / (41 pi) is 0.02 at 12.88.
  const std::vector<std::uint8_t> white{255, 255, 255};
  CHECK(lightOf(white, 12.8, 0).starts_with("too faint in the file: a background of 0.25"));
  CHECK(lightOf(white, 12.9, 0) == "as in the file");
  CHECK(lightOf({0, 128, 0}, 15, 0).starts_with("too faint"));  // 128 is decoded to 0.216
  CHECK(lightOf({0, 128, 0}, 59, 0).starts_with("too faint"));
  CHECK(lightOf({0, 128, 0}, 60, 0) == "as in the file");
  const std::vector<std::uint8_t> halfBlack{0, 0, 0, 255, 255, 255};
  CHECK(lightOf(halfBlack, 15, 0).starts_with("none in the file"));
  CHECK(lightOf(halfBlack, 15, 1) == "as in the file");
}

}  // namespace candela::gltf
