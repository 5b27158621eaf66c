// The extension KHR_materials_pbrSpecularGlossiness.
#include "tests/formats/gltf/mapped_material.h"

namespace candela::gltf {

TEST_CASE("specular-glossiness is a dielectric whose reflectance at normal incidence is the specular colour") {
  json material = metallicRoughness(0.25, 0.5);
  json& extension = material["extensions"]["KHR_materials_pbrSpecularGlossiness"];
  extension = json::object();
  const scene::SurfaceParameters mirror{.roughness = 0, .ior = 0};
  CHECK(mapped(material).surface == mirror);
  extension = {{"diffuseFactor", {0.5, 0.25, 1, 0.75}}, {"specularFactor", {1, 0, 0.125}}, {"glossinessFactor", 0.75}};
  const scene::SurfaceParameters expected{
      .baseColour = kBase, .specularColour = {1, 0, 0.125f}, .roughness = 0.25f, .ior = 0};
  CHECK(mapped(material).surface == expected);
  CHECK_FALSE(isTextured(mapped(material)));
  material["alphaMode"] = "BLEND";
  CHECK(mapped(material).opacity == scene::Opacity{.factor = 0.75f});
  for (const auto& [key, value] : std::map<const char*, json>{
           {"diffuseFactor", {1, 1, 1, 1.5}}, {"specularFactor", {1, 1, 1.5}}, {"glossinessFactor", -0.5}}) {
    json damaged = material;
    damaged["extensions"]["KHR_materials_pbrSpecularGlossiness"][key] = value;
    CHECK_THROWS_WITH(mapped(damaged), Catch::Contains(std::string("SpecularGlossiness/") + key));
  }
}

TEST_CASE("specular-glossiness has its own textures, of which one has specular colour and glossiness") {
  json material = metallicRoughness(0.25, 0.5);
  material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 5;
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = 6;
  material["alphaMode"] = "BLEND";
  material["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {{"diffuseTexture", {{"index", 7}}},
                                                                   {"specularGlossinessTexture", {{"index", 8}}}};
  const scene::Material glossy = mapped(material);
  CHECK(textureOf(glossy, scene::TextureSlot::baseColour) == kTexture7);
  CHECK(glossy.opacity->texture == kTexture7);
  CHECK(textureOf(glossy, scene::TextureSlot::specularColour)->image == 8);
  CHECK(textureOf(glossy, scene::TextureSlot::glossiness)->image == 8);
  CHECK_FALSE(textureOf(glossy, scene::TextureSlot::metallicRoughness));
}

TEST_CASE("specular-glossiness replaces metallic-roughness and its extensions, except in unlit materials") {
  json material = metallicRoughness(0.25, 0.5);
  json& extensions = material["extensions"];
  extensions["KHR_materials_pbrSpecularGlossiness"] = {{"diffuseFactor", {1, 0, 0, 1}}};
  extensions["KHR_materials_ior"]["ior"] = 2;
  extensions["KHR_materials_transmission"]["transmissionFactor"] = 1;
  extensions["KHR_materials_clearcoat"]["clearcoatFactor"] = 0.5;
  const GltfMaterial read = readMaterial(Value(material, "/materials/0"), textureOfIndex);
  CHECK(read.unread == std::set<std::string>{"KHR_materials_ior", "KHR_materials_transmission"});
  CHECK(fromGltf(read).surface->ior == 0);
  CHECK(fromGltf(read).surface->transmissionWeight == 0);
  CHECK(fromGltf(read).surface->coatWeight == 0.5f);
  extensions["KHR_materials_unlit"] = json::object();
  CHECK(mapped(material).emission == kBase);
  CHECK(readMaterial(Value(material, "/materials/0"), textureOfIndex).unread.empty());
}

}  // namespace candela::gltf
