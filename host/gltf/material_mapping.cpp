// Maps materials to lobes.
#include "host/gltf/material_mapping.h"

#include <algorithm>

namespace candela::gltf {
namespace {

constexpr double kMaxExponent = 32768;

/// The reflectance at normal incidence; glTF's ior of 0 stands for a reflectance of 1.
double normalReflectance(double ior) {
  const double root = (ior - 1) / (ior + 1);
  return root * root;
}

void addLobes(const GltfMaterial& source, scene::Material& material) {
  const glm::vec3 base(source.baseColour);
  const double metal = source.metallic;
  const double opaque = (1 - metal) * (1 - source.transmission);
  const double transmitted = (1 - metal) * source.transmission;
  const double coat = opaque * normalReflectance(source.ior);
  const double glossy = metal + coat;
  if (metal == 1 && source.roughness == 0) {
    material.mirror = scene::MirrorLobe{base};
    return;
  }
  if (opaque > coat) material.diffuse = scene::DiffuseLobe{opaque - coat, base};
  if (glossy > 0) {
    const glm::dvec3 colour = (metal * glm::dvec3(base) + glm::dvec3(coat)) / glossy;
    material.glossy = scene::GlossyLobe{glossy, glm::vec3(colour), static_cast<float>(exponentOf(source.roughness)),
                                        static_cast<float>(coat / glossy)};
  }
  if (transmitted > 0) {
    const bool isThin = source.thickness == 0;
    material.dielectric = scene::DielectricLobe{transmitted, base,
                                                isThin || source.ior == 0 ? 1 : static_cast<float>(source.ior)};
  }
}

scene::SurfaceParameters surfaceOf(const GltfMaterial& source) {
  scene::SurfaceParameters surface;
  surface.baseColour = glm::vec3(source.baseColour);
  surface.metalness = static_cast<float>(source.metallic);
  surface.roughness = static_cast<float>(source.roughness);
  surface.specularWeight = static_cast<float>(source.specular);
  surface.specularColour = source.specularColour;
  surface.ior = static_cast<float>(source.ior);
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
  set(scene::TextureSlot::specular, source.specularTexture);
  set(scene::TextureSlot::specularColour, source.specularColourTexture);
}

}  // namespace

double exponentOf(double roughness) {
  const double alpha = roughness * roughness;
  if (alpha == 0) return kMaxExponent;
  return std::min(2 / (alpha * alpha) - 2, kMaxExponent);
}

scene::Material fromGltf(const GltfMaterial& source) {
  scene::Material material;
  if (source.isUnlit) {
    material.emission = glm::vec3(source.baseColour);
    material.textures[static_cast<std::size_t>(scene::TextureSlot::emission)] = source.baseColourTexture;
  } else {
    if (source.transmission > 0) {
      addLobes(source, material);
    } else {
      material.surface = surfaceOf(source);
    }
    material.emission = source.emission;
    addTextures(source, material);
  }
  if (source.alphaMode != AlphaMode::opaque) {
    material.opacity = scene::Opacity{.factor = source.baseColour.w, .texture = source.baseColourTexture};
    if (source.alphaMode == AlphaMode::mask) material.opacity->cutoff = static_cast<float>(source.alphaCutoff);
  }
  material.opaque = !source.isDoubleSided && !material.dielectric;
  return material;
}

}  // namespace candela::gltf
