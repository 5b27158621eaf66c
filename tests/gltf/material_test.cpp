// Materials: what is read, and the lobes that are made of it.
#include "host/gltf/material_mapping.h"
#include "tests/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

// A reference whose image is the index of the texture.
scene::TextureReference textureOfIndex(const Value& info) {
  return {.image = static_cast<std::uint32_t>(info.require("index").whole())};
}

scene::Material mapped(const json& material) {
  return fromGltf(readMaterial(Value(material, "/materials/0"), textureOfIndex));
}

const scene::TextureReference kTexture7{.image = 7};

json metallicRoughness(double metallic, double roughness) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}}}};
}

const glm::vec3 kBase{0.5f, 0.25f, 1};

}  // namespace

TEST_CASE("a dielectric is diffuse below a white coat of 4 percent") {
  const scene::Material material = mapped(metallicRoughness(0, 0.5));
  REQUIRE(material.diffuse);
  REQUIRE(material.glossy);
  CHECK(material.diffuse->colour == kBase);
  CHECK(material.diffuse->weight == Approx(0.96));
  CHECK(material.glossy->weight == Approx(0.04));
  CHECK(material.glossy->colour == glm::vec3(1));
  CHECK(material.glossy->exponent == Approx(30));  // 2 / (0.5^2)^2 - 2
}

TEST_CASE("a metal reflects its base colour, and a smooth one is a mirror") {
  const scene::Material rough = mapped(metallicRoughness(1, 1));
  CHECK_FALSE(rough.diffuse);
  CHECK(rough.glossy == scene::GlossyLobe{1, kBase, 0, 0});
  const scene::Material smooth = mapped(metallicRoughness(1, 0));
  CHECK(smooth.mirror == scene::MirrorLobe{kBase});
  CHECK_FALSE(smooth.glossy);
}

TEST_CASE("a base colour texture scales all colours but that of a dielectric's highlights") {
  json material = metallicRoughness(0.5, 0.5);
  material["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 7;
  const scene::Material half = mapped(material);
  CHECK(textureOf(half, scene::TextureSlot::baseColour) == kTexture7);
  CHECK(half.glossy->untinted == Approx(0.02 / 0.52));
  CHECK(half.glossy->colour.x == Approx((0.5 * kBase.x + 0.02) / 0.52));
}

TEST_CASE("weights of all mixtures sum to 1") {
  for (const double metallic : {0.0, 0.3, 1.0}) {
    for (const double transmission : {0.0, 0.6, 1.0}) {
      json material = metallicRoughness(metallic, 0.3);
      material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = transmission;
      const scene::Material m = mapped(material);
      const double sum = (m.diffuse ? m.diffuse->weight : 0) + (m.glossy ? m.glossy->weight : 0) +
                         (m.dielectric ? m.dielectric->weight : 0);
      CHECK(sum == Approx(1));
    }
  }
}

TEST_CASE("what transmits refracts if it has a thickness, and lets light pass straight if it has none") {
  json material = metallicRoughness(0, 0);
  material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 1;
  CHECK(mapped(material).dielectric == scene::DielectricLobe{1, kBase, 1});
  material["extensions"]["KHR_materials_volume"]["thicknessFactor"] = 0.1;
  CHECK(mapped(material).dielectric == scene::DielectricLobe{1, kBase, 1.5f});
  material["extensions"]["KHR_materials_ior"]["ior"] = 2;
  CHECK(mapped(material).dielectric->ior == 2);
  CHECK_FALSE(mapped(material).opaque);
}

TEST_CASE("emission has a strength and a texture, and unlit surfaces shine by their colour") {
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
}

TEST_CASE("backs of single-sided surfaces can be left out, those of others not") {
  CHECK(mapped(json::object()).opaque);
  CHECK_FALSE(mapped({{"doubleSided", true}}).opaque);
}

TEST_CASE("primitives without a material share the default, a rough white metal") {
  GltfFile file = triangleFile();
  file.addMesh(file.primitive());
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.materials.size() == 1);
  CHECK(scene.materials[0].glossy == scene::GlossyLobe{1, {1, 1, 1}, 0});
}

TEST_CASE("one warning lists what is not rendered") {
  GltfFile file = triangleFile();
  json material{{"alphaMode", "BLEND"}, {"normalTexture", {{"index", 0}}}};
  material["extensions"]["KHR_materials_sheen"] = json::object();
  file.root["materials"] = {material};
  CHECK(warns(load(file), "not rendered yet: KHR_materials_sheen, alpha mode BLEND, normal texture"));
}

}  // namespace candela::gltf
