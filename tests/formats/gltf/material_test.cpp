// Materials: their properties, and their surface parameters.
#include <algorithm>
#include <map>
#include <numbers>

#include "tests/formats/gltf/mapped_material.h"

namespace candela::gltf {

TEST_CASE("metallic-roughness factors are the parameters of a surface") {
  const scene::Material material = mapped(metallicRoughness(0.25, 0.5));
  REQUIRE(material.surface);
  CHECK(*material.surface == scene::SurfaceParameters{.baseColour = kBase, .metalness = 0.25f, .roughness = 0.5f});
  CHECK(kindOf(material) == scene::MaterialKind::surface);
}

TEST_CASE("factors that rounding put beyond 1 count as 1, and emission above 1 is emitted") {
  json material = metallicRoughness(1.0000002, -2e-8);
  material["pbrMetallicRoughness"]["baseColorFactor"] = {1.00000012, 0.25, 1, 1};
  material["emissiveFactor"] = {2, 0, 1.5};
  const scene::Material result = mapped(material);
  CHECK(result.surface->baseColour == glm::vec3(1, 0.25f, 1));
  CHECK(result.surface->metalness == 1);
  CHECK(result.surface->roughness == mapped(metallicRoughness(1, 0)).surface->roughness);
  CHECK(result.emission == glm::vec3(2, 0, 1.5f));
  CHECK_THROWS_WITH(mapped(metallicRoughness(1.001, 0)), Catch::Contains("1.001 is outside 0 to 1"));
}

TEST_CASE("specular factors and the index of refraction are parameters, too") {
  json material;
  material["extensions"]["KHR_materials_specular"] = {{"specularFactor", 0.5}, {"specularColorFactor", {1, 2, 0}}};
  material["extensions"]["KHR_materials_ior"]["ior"] = 0;
  const scene::SurfaceParameters expected{
      .metalness = 1, .specularColour = {1, 2, 0}, .specularWeight = 0.5f, .ior = 0};
  CHECK(mapped(material).surface == expected);
  material["extensions"]["KHR_materials_specular"]["specularColorFactor"] = {1, -1, 0};
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("textures of a surface are those of its slots") {
  json material;
  material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7;
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 8;
  material["extensions"]["KHR_materials_specular"] = {{"specularTexture", {{"index", 9}}},
                                                      {"specularColorTexture", {{"index", 10}}}};
  const scene::Material surface = mapped(material);
  CHECK(textureOf(surface, scene::TextureSlot::baseColour)->image == 7);
  CHECK(textureOf(surface, scene::TextureSlot::metallicRoughness)->image == 8);
  CHECK(textureOf(surface, scene::TextureSlot::specular)->image == 9);
  CHECK(textureOf(surface, scene::TextureSlot::specularColour)->image == 10);
}

TEST_CASE("alpha modes decide the opacity of triangles") {
  json material{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.25}}, {"baseColorTexture", {{"index", 7}}}}}};
  CHECK_FALSE(mapped(material).opacity);
  material["alphaMode"] = "BLEND";
  CHECK(mapped(material).opacity == scene::Opacity{.factor = 0.25f, .texture = kTexture7});
  material["alphaMode"] = "MASK";
  CHECK(mapped(material).opacity == scene::Opacity{.factor = 0.25f, .cutoff = 0.5f, .texture = kTexture7});
  material["alphaCutoff"] = 0.125;
  CHECK(mapped(material).opacity->cutoff == 0.125f);
}

TEST_CASE("a transmitting surface bounds a volume if it has a thickness, and is a thin wall otherwise") {
  json material = metallicRoughness(0, 0);
  material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.75;
  CHECK(mapped(material).surface->transmissionWeight == 0.75f);
  CHECK_FALSE(mapped(material).surface->hasVolume());
  material["extensions"]["KHR_materials_volume"] = {{"thicknessFactor", 0.1}};
  CHECK(mapped(material).surface->hasVolume());
  CHECK(mapped(material).surface->absorption == glm::vec3(0));
  CHECK_FALSE(mapped(material).opaque);
  material["extensions"]["KHR_materials_ior"]["ior"] = 0;
  CHECK(mapped(material).surface->transmissionWeight == 0);
}

TEST_CASE("white light has the attenuation colour after the attenuation distance") {
  json material = metallicRoughness(0, 0);
  material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 1;
  json& volume = material["extensions"]["KHR_materials_volume"];
  volume = {{"thicknessFactor", 1}, {"attenuationColor", {0.25, 1, 0}}, {"attenuationDistance", 2}};
  const glm::vec3 absorption = mapped(material).surface->absorption;
  CHECK(std::exp(-2 * absorption.x) == Approx(0.25));
  CHECK(absorption.y == 0);
  CHECK(std::exp(-2 * absorption.z) < 1e-37f);
  volume["attenuationDistance"] = 0;
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("a clearcoat is the coat of a surface") {
  json material;
  material["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.25}};
  CHECK(mapped(material).surface->coatWeight == 0.5f);
  CHECK(mapped(material).surface->coatRoughness == 0.25f);
}

TEST_CASE("transmission and clearcoat have textures, if their factors are not 0") {
  json material;
  json& extensions = material["extensions"];
  extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1}, {"transmissionTexture", {{"index", 3}}}};
  extensions["KHR_materials_clearcoat"] = {{"clearcoatFactor", 1},
                                           {"clearcoatTexture", {{"index", 4}}},
                                           {"clearcoatRoughnessTexture", {{"index", 5}}},
                                           {"clearcoatNormalTexture", {{"index", 6}, {"scale", 0.25}}}};
  const scene::Material coated = mapped(material);
  CHECK(textureOf(coated, scene::TextureSlot::transmission)->image == 3);
  CHECK(textureOf(coated, scene::TextureSlot::coat)->image == 4);
  CHECK(textureOf(coated, scene::TextureSlot::coatRoughness)->image == 5);
  CHECK(textureOf(coated, scene::TextureSlot::coatNormal)->image == 6);
  CHECK(coated.coatNormalScale == 0.25f);
  CHECK(coated.normalScale == 1);
  CHECK(tangentTextureOf(coated)->image == 6);
  extensions["KHR_materials_transmission"]["transmissionFactor"] = 0;
  extensions["KHR_materials_clearcoat"]["clearcoatFactor"] = 0;
  CHECK_FALSE(isTextured(mapped(material)));
}

TEST_CASE("sheen has a colour and a roughness, with textures unless it is black") {
  json material;
  json& sheen = material["extensions"]["KHR_materials_sheen"];
  sheen = {
      {"sheenRoughnessFactor", 0.25}, {"sheenColorTexture", {{"index", 7}}}, {"sheenRoughnessTexture", {{"index", 8}}}};
  CHECK(mapped(material).surface->sheenColour == glm::vec3(0));
  CHECK_FALSE(textureOf(mapped(material), scene::TextureSlot::sheenColour));
  sheen["sheenColorFactor"] = {0.5, 1, 0};
  CHECK(mapped(material).surface->sheenColour == glm::vec3(0.5f, 1, 0));
  CHECK(mapped(material).surface->sheenRoughness == 0.25f);
  CHECK(textureOf(mapped(material), scene::TextureSlot::sheenColour)->image == 7);
  CHECK(textureOf(mapped(material), scene::TextureSlot::sheenRoughness)->image == 8);
  sheen["sheenColorFactor"] = {0.5, 1.5, 0};
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("anisotropy has a strength, a rotation and a texture, along whose coordinates tangents run") {
  json material;
  json& anisotropy = material["extensions"]["KHR_materials_anisotropy"];
  anisotropy = {{"anisotropyRotation", 7}, {"anisotropyTexture", {{"index", 3}}}};
  CHECK_FALSE(isTextured(mapped(material)));
  CHECK_FALSE(tangentTextureOf(mapped(material)));
  anisotropy["anisotropyStrength"] = 0.25;
  const scene::Material brushed = mapped(material);
  CHECK(brushed.surface->anisotropy == 0.25f);
  CHECK(brushed.surface->anisotropyRotation == Approx(7 - 2 * std::numbers::pi));
  CHECK(textureOf(brushed, scene::TextureSlot::anisotropy)->image == 3);
  CHECK(tangentTextureOf(brushed)->image == 3);
  material["normalTexture"] = {{"index", 5}};
  CHECK(tangentTextureOf(mapped(material))->image == 5);
  material.erase("normalTexture");
  anisotropy.erase("anisotropyTexture");
  CHECK(tangentTextureOf(mapped(material)) == scene::TextureReference{});
  anisotropy["anisotropyStrength"] = 1.5;
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("iridescence is a thin film") {
  json material;
  json& film = material["extensions"]["KHR_materials_iridescence"];
  film = {{"iridescenceFactor", 0.5},
          {"iridescenceIor", 1.5},
          {"iridescenceThicknessMinimum", 200},
          {"iridescenceThicknessMaximum", 800},
          {"iridescenceTexture", {{"index", 7}}},
          {"iridescenceThicknessTexture", {{"index", 8}}}};
  const scene::Material mappedFilm = mapped(material);
  CHECK(*mappedFilm.surface ==
        scene::SurfaceParameters{
            .metalness = 1, .filmWeight = 0.5f, .filmIor = 1.5f, .filmThickness = 800, .filmThicknessMinimum = 200});
  CHECK(textureOf(mappedFilm, scene::TextureSlot::film)->image == 7);
  CHECK(textureOf(mappedFilm, scene::TextureSlot::filmThickness)->image == 8);
  film["iridescenceIor"] = 0.9;
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("dispersion belongs to volumes whose index of refraction exceeds 1") {
  json material;
  json& extensions = material["extensions"];
  extensions["KHR_materials_dispersion"] = {{"dispersion", 0.36}};
  extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
  CHECK(mapped(material).surface->transmissionDispersionScale == 0.36f);
  CHECK_FALSE(mapped(material).surface->disperses());
  extensions["KHR_materials_volume"] = {{"thicknessFactor", 1}};
  CHECK(mapped(material).surface->disperses());
  extensions["KHR_materials_ior"] = {{"ior", 1}};
  CHECK_FALSE(mapped(material).surface->disperses());
  extensions.erase("KHR_materials_ior");
  extensions["KHR_materials_dispersion"] = json::object();
  CHECK_FALSE(mapped(material).surface->disperses());
  extensions["KHR_materials_dispersion"] = {{"dispersion", -0.1}};
  CHECK_THROWS_AS(mapped(material), JsonError);
}

TEST_CASE("a conductor has a complex index of refraction") {
  json material;
  json& conductor = material["extensions"]["CANDELA_materials_conductor"];
  conductor = {{"ior", {0.25, 0.5, 1.5}}, {"extinction", {4, 2, 1}}};
  CHECK(mapped(material).surface->conductor == scene::Conductor{{0.25f, 0.5f, 1.5f}, {4, 2, 1}});
  conductor["extinction"] = {4, -1, 0};
  CHECK_THROWS_AS(mapped(material), JsonError);
  conductor = {{"ior", {0, 1, 1}}};
  CHECK_THROWS_AS(mapped(material), JsonError);
  CHECK_FALSE(mapped(json::object()).surface->conductor);
}

TEST_CASE("emission has a strength and a texture, and unlit surfaces emit their colour") {
  json material{{"emissiveFactor", {1, 0.5, 0}}};
  material["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 8;
  CHECK(mapped(material).emission == glm::vec3(8, 4, 0));
  material["emissiveTexture"]["index"] = 7;
  CHECK(textureOf(mapped(material), scene::TextureSlot::emission) == kTexture7);
  json unlit = metallicRoughness(0, 1);
  unlit["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7;
  unlit["extensions"]["KHR_materials_unlit"] = json::object();
  CHECK(mapped(unlit).emission == kBase);
  CHECK(textureOf(mapped(unlit), scene::TextureSlot::emission) == kTexture7);
  CHECK(kindOf(mapped(unlit)) == scene::MaterialKind::black);
  CHECK(mapped(unlit).coloursScaleEmission);
  CHECK_FALSE(mapped(material).coloursScaleEmission);
}

TEST_CASE("backs of single-sided surfaces can be removed, those of others cannot") {
  CHECK(mapped(json::object()).opaque);
  CHECK_FALSE(mapped({{"doubleSided", true}}).opaque);
}

TEST_CASE("primitives without a material share the default, a rough white metal") {
  GltfFile file = triangleFile();
  file.addMesh(file.primitive());
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.materials.size() == 1);
  CHECK(scene.materials[0].surface == scene::SurfaceParameters{.metalness = 1});
}

TEST_CASE("one warning lists the features that are not rendered, and occlusion textures are a fact") {
  GltfFile file = triangleFile();
  json material{{"occlusionTexture", {{"index", 0}}}};
  file.root["materials"] = json::array({material});
  const scene::LoadedScene loaded = load(file);
  CHECK_FALSE(warns(loaded, "not rendered"));
  CHECK(std::ranges::count(loaded.facts, std::pair<std::string, std::string>(
                                             "not used", "occlusion textures (light is traced)")) == 1);
  material["extensions"]["EXT_example"] = json::object();
  file.root["materials"] = json::array({material});
  CHECK(warns(load(file), "not rendered yet: EXT_example"));
}

}  // namespace candela::gltf
