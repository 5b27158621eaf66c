// Reads materials.
#include "host/formats/gltf/gltf_material.h"

#include <algorithm>
#include <array>

#include "host/base/quote.h"
#include "host/formats/gltf/material_factors.h"

namespace candela::gltf {
namespace {

/// KHR_materials_specular.
void readSpecular(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> specular = extensionOf(material, "KHR_materials_specular");
  if (!specular) return;
  result.specular = fraction(*specular, "specularFactor", 1);
  result.specularColour = atLeastZero(*specular, "specularColorFactor", glm::vec3(1));
  result.specularTexture = textureIn(*specular, "specularTexture", readTexture);
  result.specularColourTexture = textureIn(*specular, "specularColorTexture", readTexture);
}

/// KHR_materials_ior, KHR_materials_transmission and KHR_materials_volume.
void readTransmission(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  if (const std::optional<Value> ior = extensionOf(material, "KHR_materials_ior")) {
    result.ior = ior->numberOr("ior", 1.5);
    if (result.ior != 0 && result.ior < 1)
      ior->require("ior").fail("the index of refraction is neither 0 nor at least 1");
  }
  const std::optional<Value> transmission = extensionOf(material, "KHR_materials_transmission");
  if (!transmission) return;
  result.transmission = fraction(*transmission, "transmissionFactor", 0);
  result.transmissionTexture = textureIn(*transmission, "transmissionTexture", readTexture);
  const std::optional<Value> volume = extensionOf(material, "KHR_materials_volume");
  if (!volume) return;
  result.thickness = atLeastZero(*volume, "thicknessFactor", 0);
  result.attenuationColour = fractions(*volume, "attenuationColor", glm::vec3(1));
  if (!volume->find("attenuationDistance")) return;
  result.attenuationDistance = atLeastZero(*volume, "attenuationDistance", 0);
  if (result.attenuationDistance == 0) volume->require("attenuationDistance").fail("0 is not positive");
}

/// KHR_materials_dispersion.
void readDispersion(const Value& material, GltfMaterial& result) {
  const std::optional<Value> dispersion = extensionOf(material, "KHR_materials_dispersion");
  if (dispersion) result.dispersion = atLeastZero(*dispersion, "dispersion", 0);
}

/// KHR_materials_clearcoat.
void readClearcoat(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> coat = extensionOf(material, "KHR_materials_clearcoat");
  if (!coat) return;
  result.clearcoat = fraction(*coat, "clearcoatFactor", 0);
  result.clearcoatRoughness = fraction(*coat, "clearcoatRoughnessFactor", 0);
  result.clearcoatTexture = textureIn(*coat, "clearcoatTexture", readTexture);
  result.clearcoatRoughnessTexture = textureIn(*coat, "clearcoatRoughnessTexture", readTexture);
  result.clearcoatNormalTexture = textureIn(*coat, "clearcoatNormalTexture", readTexture);
  result.clearcoatNormalScale = scaleIn(*coat, "clearcoatNormalTexture");
}

/// KHR_materials_sheen.
void readSheen(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> sheen = extensionOf(material, "KHR_materials_sheen");
  if (!sheen) return;
  result.sheenColour = fractions(*sheen, "sheenColorFactor", glm::vec3(0));
  result.sheenRoughness = fraction(*sheen, "sheenRoughnessFactor", 0);
  result.sheenColourTexture = textureIn(*sheen, "sheenColorTexture", readTexture);
  result.sheenRoughnessTexture = textureIn(*sheen, "sheenRoughnessTexture", readTexture);
}

/// KHR_materials_iridescence.
void readIridescence(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> film = extensionOf(material, "KHR_materials_iridescence");
  if (!film) return;
  result.iridescence = fraction(*film, "iridescenceFactor", 0);
  result.iridescenceIor = film->numberOr("iridescenceIor", 1.3);
  if (result.iridescenceIor < 1) film->require("iridescenceIor").fail("the index of refraction is below 1");
  result.iridescenceMinimum = atLeastZero(*film, "iridescenceThicknessMinimum", 100);
  result.iridescenceMaximum = atLeastZero(*film, "iridescenceThicknessMaximum", 400);
  result.iridescenceTexture = textureIn(*film, "iridescenceTexture", readTexture);
  result.iridescenceThicknessTexture = textureIn(*film, "iridescenceThicknessTexture", readTexture);
}

/// KHR_materials_anisotropy.
void readAnisotropy(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> anisotropy = extensionOf(material, "KHR_materials_anisotropy");
  if (!anisotropy) return;
  result.anisotropy = fraction(*anisotropy, "anisotropyStrength", 0);
  result.anisotropyRotation = anisotropy->numberOr("anisotropyRotation", 0);
  result.anisotropyTexture = textureIn(*anisotropy, "anisotropyTexture", readTexture);
}

/// CANDELA_materials_conductor: docs/gltf.md.
void readConductor(const Value& material, GltfMaterial& result) {
  const std::optional<Value> extension = extensionOf(material, "CANDELA_materials_conductor");
  if (!extension) return;
  scene::Conductor conductor{.ior = extension->vectorOr("ior", glm::vec3(0)),
                             .extinction = atLeastZero(*extension, "extinction", glm::vec3(0))};
  if (glm::any(glm::lessThanEqual(conductor.ior, glm::vec3(0)))) {
    extension->require("ior").fail("a component is not positive");
  }
  result.conductor = conductor;
}

constexpr const char* kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

/// Extensions whose values GltfMaterial has, all of them or some.
constexpr std::array kRead{
    "KHR_materials_emissive_strength", "KHR_materials_unlit",      "KHR_materials_clearcoat", "KHR_materials_sheen",
    "KHR_materials_iridescence",       "KHR_materials_anisotropy", kSpecularGlossiness};

/// Extensions of pbrMetallicRoughness, which count unless the material has KHR_materials_pbrSpecularGlossiness.
constexpr std::array kOfMetallicRoughness{"KHR_materials_ior",          "KHR_materials_specular",
                                          "KHR_materials_transmission", "KHR_materials_volume",
                                          "KHR_materials_dispersion",   "CANDELA_materials_conductor"};

AlphaMode alphaModeOf(const Value& material) {
  const std::string mode = material.textOr("alphaMode", "OPAQUE");
  if (mode == "OPAQUE") return AlphaMode::opaque;
  if (mode == "MASK") return AlphaMode::mask;
  if (mode != "BLEND") material.require("alphaMode").fail(scene::quote(mode) + " is not OPAQUE, MASK or BLEND");
  return AlphaMode::blend;
}

void readMetallicRoughness(const Value& pbr, const TextureReader& readTexture, GltfMaterial& result) {
  result.baseColour = fractions(pbr, "baseColorFactor", glm::vec4(1));
  result.metallic = fraction(pbr, "metallicFactor", 1);
  result.roughness = fraction(pbr, "roughnessFactor", 1);
  result.baseColourTexture = textureIn(pbr, "baseColorTexture", readTexture);
  result.metallicRoughnessTexture = textureIn(pbr, "metallicRoughnessTexture", readTexture);
}

/// Factors above 1, which exporters wrote before KHR_materials_emissive_strength existed, are used as they are.
void readEmission(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  result.emission = atLeastZero(material, "emissiveFactor", glm::vec3(0));
  if (const std::optional<Value> strength = extensionOf(material, "KHR_materials_emissive_strength")) {
    result.emission *= static_cast<float>(atLeastZero(*strength, "emissiveStrength", 1));
  }
  result.emissionTexture = textureIn(material, "emissiveTexture", readTexture);
}

void readNormalMap(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  result.normalTexture = textureIn(material, "normalTexture", readTexture);
  result.normalScale = scaleIn(material, "normalTexture");
}

/// The parameters of pbrMetallicRoughness and of the extensions that change its dielectric or its metal.
void readMetallicRoughnessModel(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  if (const std::optional<Value> pbr = material.find("pbrMetallicRoughness"))
    readMetallicRoughness(*pbr, readTexture, result);
  readSpecular(material, readTexture, result);
  readTransmission(material, readTexture, result);
  readDispersion(material, result);
  readConductor(material, result);
}

/// A dielectric with the reflectance `specularFactor` at normal incidence. `pbrMetallicRoughness` is not read: it is
/// what programs without the extension show.
void readSpecularGlossiness(const Value& extension, const TextureReader& readTexture, GltfMaterial& result) {
  result.baseColour = fractions(extension, "diffuseFactor", glm::vec4(1));
  result.metallic = 0;
  result.ior = 0;
  result.specularColour = fractions(extension, "specularFactor", glm::vec3(1));
  result.roughness = 1 - fraction(extension, "glossinessFactor", 1);
  result.baseColourTexture = textureIn(extension, "diffuseTexture", readTexture);
  result.specularColourTexture = textureIn(extension, "specularGlossinessTexture", readTexture);
  result.glossinessTexture = result.specularColourTexture;
}

/// Returns the extension by which the surface is described; nothing: by pbrMetallicRoughness. An unlit material emits
/// the base colour of pbrMetallicRoughness.
std::optional<Value> specularGlossinessOf(const Value& material) {
  if (extensionOf(material, "KHR_materials_unlit")) return std::nullopt;
  return extensionOf(material, kSpecularGlossiness);
}

std::string withoutQuotes(const std::string& quoted) { return quoted.substr(1, quoted.size() - 2); }

void noteExtensions(const Value& material, GltfMaterial& result) {
  const std::optional<Value> extensions = material.find("extensions");
  if (!extensions || !extensions->json().is_object()) return;
  for (const auto& [name, value] : extensions->json().items()) {
    const bool isOfModel = !specularGlossinessOf(material) && std::ranges::count(kOfMetallicRoughness, name) > 0;
    if (!isOfModel && std::ranges::count(kRead, name) == 0) result.unread.insert(withoutQuotes(scene::quote(name)));
  }
}

}  // namespace

GltfMaterial readMaterial(const Value& material, const TextureReader& readTexture) {
  GltfMaterial result;
  if (const std::optional<Value> extension = specularGlossinessOf(material)) {
    readSpecularGlossiness(*extension, readTexture, result);
  } else {
    readMetallicRoughnessModel(material, readTexture, result);
  }
  readEmission(material, readTexture, result);
  readClearcoat(material, readTexture, result);
  readNormalMap(material, readTexture, result);
  readSheen(material, readTexture, result);
  readIridescence(material, readTexture, result);
  readAnisotropy(material, readTexture, result);
  result.alphaMode = alphaModeOf(material);
  result.alphaCutoff = atLeastZero(material, "alphaCutoff", 0.5);
  result.isDoubleSided = material.booleanOr("doubleSided", false);
  result.isUnlit = extensionOf(material, "KHR_materials_unlit").has_value();
  result.hasOcclusion = material.find("occlusionTexture").has_value();
  noteExtensions(material, result);
  return result;
}

}  // namespace candela::gltf
