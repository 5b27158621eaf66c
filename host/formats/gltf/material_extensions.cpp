// Reads the extensions of materials, except those that replace the metallic-roughness model.
#include "host/formats/gltf/material_extensions.h"

#include "host/formats/gltf/material_factors.h"

namespace candela::gltf {

void readSpecular(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> specular = extensionOf(material, "KHR_materials_specular");
  if (!specular) return;
  result.specular = fraction(*specular, "specularFactor", 1);
  result.specularColour = atLeastZero(*specular, "specularColorFactor", glm::vec3(1));
  result.specularTexture = textureIn(*specular, "specularTexture", readTexture);
  result.specularColourTexture = textureIn(*specular, "specularColorTexture", readTexture);
}

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

void readDispersion(const Value& material, GltfMaterial& result) {
  const std::optional<Value> dispersion = extensionOf(material, "KHR_materials_dispersion");
  if (dispersion) result.dispersion = atLeastZero(*dispersion, "dispersion", 0);
}

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

void readSheen(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> sheen = extensionOf(material, "KHR_materials_sheen");
  if (!sheen) return;
  result.sheenColour = fractions(*sheen, "sheenColorFactor", glm::vec3(0));
  result.sheenRoughness = fraction(*sheen, "sheenRoughnessFactor", 0);
  result.sheenColourTexture = textureIn(*sheen, "sheenColorTexture", readTexture);
  result.sheenRoughnessTexture = textureIn(*sheen, "sheenRoughnessTexture", readTexture);
}

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

void readAnisotropy(const Value& material, const TextureReader& readTexture, GltfMaterial& result) {
  const std::optional<Value> anisotropy = extensionOf(material, "KHR_materials_anisotropy");
  if (!anisotropy) return;
  result.anisotropy = fraction(*anisotropy, "anisotropyStrength", 0);
  result.anisotropyRotation = anisotropy->numberOr("anisotropyRotation", 0);
  result.anisotropyTexture = textureIn(*anisotropy, "anisotropyTexture", readTexture);
}

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

}  // namespace candela::gltf
