// Maps materials to parameters of surfaces.
#include "host/formats/gltf/material_mapping.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace candela::gltf {
namespace {

// The attenuation colour is the colour of white light after the attenuation distance. No volume absorbs all light at
// once: the smallest positive float replaces 0.
glm::vec3 absorptionOf(const GltfMaterial& source) {
  if (source.attenuationDistance == 0) return glm::vec3(0);
  const glm::vec3 colour = glm::max(source.attenuationColour, std::numeric_limits<float>::min());
  return glm::vec3(-glm::log(glm::dvec3(colour)) / source.attenuationDistance);
}

scene::SurfaceParameters surfaceOf(const GltfMaterial& source) {
  scene::SurfaceParameters surface;
  surface.baseColour = glm::vec3(source.baseColour);
  surface.metalness = static_cast<float>(source.metallic);
  surface.roughness = static_cast<float>(source.roughness);
  surface.specularWeight = static_cast<float>(source.specular);
  surface.specularColour = source.specularColour;
  surface.ior = static_cast<float>(source.ior);
  if (source.ior > 0) surface.transmissionWeight = static_cast<float>(source.transmission);  // ior 0 reflects all light
  surface.isThinWalled = source.thickness == 0 || surface.transmissionWeight == 0;
  surface.transmissionDispersionScale = static_cast<float>(source.dispersion);
  surface.absorption = absorptionOf(source);
  surface.coatWeight = static_cast<float>(source.clearcoat);
  surface.coatRoughness = static_cast<float>(source.clearcoatRoughness);
  surface.filmWeight = static_cast<float>(source.iridescence);
  surface.filmIor = static_cast<float>(source.iridescenceIor);
  surface.filmThickness = static_cast<float>(source.iridescenceMaximum);
  surface.filmThicknessMinimum = static_cast<float>(source.iridescenceMinimum);
  surface.anisotropy = static_cast<float>(source.anisotropy);
  surface.anisotropyRotation = static_cast<float>(std::remainder(source.anisotropyRotation, 2 * std::numbers::pi));
  surface.conductor = source.conductor;
  surface.sheenColour = source.sheenColour;
  surface.sheenRoughness = static_cast<float>(source.sheenRoughness);
  return surface;
}

/// Lobes have no roughness that a texture could scale.
void addTextures(const GltfMaterial& source, scene::Material& material) {
  const auto set = [&](scene::TextureSlot slot, const std::optional<scene::TextureReference>& texture) {
    material.textures[static_cast<std::size_t>(slot)] = texture;
  };
  set(scene::TextureSlot::baseColour, source.baseColourTexture);
  if (isEmissive(material)) set(scene::TextureSlot::emission, source.emissionTexture);
  if (!material.surface) return;
  set(scene::TextureSlot::metallicRoughness, source.metallicRoughnessTexture);
  set(scene::TextureSlot::glossiness, source.glossinessTexture);
  set(scene::TextureSlot::specular, source.specularTexture);
  set(scene::TextureSlot::specularColour, source.specularColourTexture);
  set(scene::TextureSlot::normal, source.normalTexture);
  material.normalScale = static_cast<float>(source.normalScale);
  if (material.surface->transmissionWeight > 0) set(scene::TextureSlot::transmission, source.transmissionTexture);
  if (material.surface->coatWeight > 0) {
    set(scene::TextureSlot::coat, source.clearcoatTexture);
    set(scene::TextureSlot::coatRoughness, source.clearcoatRoughnessTexture);
    set(scene::TextureSlot::coatNormal, source.clearcoatNormalTexture);
    material.coatNormalScale = static_cast<float>(source.clearcoatNormalScale);
  }
  if (source.sheenColour != glm::vec3(0)) {
    set(scene::TextureSlot::sheenColour, source.sheenColourTexture);
    set(scene::TextureSlot::sheenRoughness, source.sheenRoughnessTexture);
  }
  if (source.iridescence > 0) {
    set(scene::TextureSlot::film, source.iridescenceTexture);
    set(scene::TextureSlot::filmThickness, source.iridescenceThicknessTexture);
  }
  if (source.anisotropy > 0) set(scene::TextureSlot::anisotropy, source.anisotropyTexture);
}

}  // namespace

scene::Material fromGltf(const GltfMaterial& source) {
  scene::Material material;
  if (source.isUnlit) {
    material.emission = glm::vec3(source.baseColour);
    material.coloursScaleEmission = true;
    material.textures[static_cast<std::size_t>(scene::TextureSlot::emission)] = source.baseColourTexture;
  } else {
    material.surface = surfaceOf(source);
    material.emission = source.emission;
    addTextures(source, material);
  }
  if (source.alphaMode != AlphaMode::opaque) {
    material.opacity = scene::Opacity{.factor = source.baseColour.w, .texture = source.baseColourTexture};
    if (source.alphaMode == AlphaMode::mask) material.opacity->cutoff = static_cast<float>(source.alphaCutoff);
  }
  material.opaque = !source.isDoubleSided && source.transmission == 0;
  return material;
}

}  // namespace candela::gltf
