// Maps materials of MTL files to lobes or to parameters of surfaces.
#include "host/formats/obj/mtl_mapping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/formats/loading/model_scene.h"

namespace candela::obj {
namespace {

using scene::TextureSlot;

constexpr float kGlassIor = 1.5f;        // of materials that refract and state none
constexpr float kSheenRoughness = 0.5f;  // MTL has no number for it

bool isPhysical(const MtlMaterial& m) {
  return m.roughness || m.metalness || m.sheen || m.coat || m.coatRoughness || m.anisotropy || m.rotation ||
         m.maps.contains(MapKind::roughness) || m.maps.contains(MapKind::metalness);
}

/// The illumination models that refract.
bool isGlass(const MtlMaterial& m) { return m.illumination == 6 || m.illumination == 7; }

/// The models with reflections of other objects, which are those of a mirror.
bool isMirror(const MtlMaterial& m) { return m.illumination == 3 || m.illumination == 5 || m.illumination == 8; }

/// The models without highlights.
bool isMatt(const MtlMaterial& m) { return m.illumination == 0 || m.illumination == 1; }

/// The GGX roughness whose microfacets have about the spread of Blinn's exponent: alpha² = 2/(Ns + 2), of which the
/// perceptual roughness is the square root (Walter et al., "Microfacet Models for Refraction through Rough Surfaces",
/// 2007, section 5.2).
float roughnessOf(float exponent) { return static_cast<float>(std::pow(2 / (double{exponent} + 2), 0.25)); }

glm::vec3 limited(const glm::vec3& colour) { return glm::min(colour, glm::vec3(1)); }

glm::vec3 diffuseOf(const MtlMaterial& m, bool hasColours) {
  if (m.diffuse) return limited(*m.diffuse);
  const bool isWhite = hasColours || m.maps.contains(MapKind::diffuse);
  return scene::plainMaterial(isWhite).diffuse->colour;
}

void set(scene::Material& material, TextureSlot slot, const std::optional<scene::TextureReference>& texture) {
  material.textures[static_cast<std::size_t>(slot)] = texture;
}

/// The extension for physically based materials.
scene::SurfaceParameters physicalSurface(const MtlMaterial& m, const MtlReferences& textures) {
  scene::SurfaceParameters surface;
  const float exponentRoughness = m.exponent ? roughnessOf(*m.exponent) : 1;
  surface.roughness = m.roughness.value_or(textures.metallicRoughness ? 1 : exponentRoughness);
  surface.metalness = m.metalness.value_or(m.maps.contains(MapKind::metalness) && textures.metallicRoughness ? 1 : 0);
  if (m.ior && *m.ior >= 1) surface.ior = *m.ior;
  surface.sheenColour = glm::vec3(m.sheen.value_or(0));
  surface.sheenRoughness = kSheenRoughness;
  surface.coatWeight = m.coat.value_or(0);
  surface.coatRoughness = m.coatRoughness.value_or(0);
  surface.anisotropy = m.anisotropy.value_or(0);
  surface.anisotropyRotation = static_cast<float>(
      std::remainder(2 * std::numbers::pi * double{m.rotation.value_or(0)}, 2 * std::numbers::pi));
  return surface;
}

/// Ks is the reflectance at normal incidence, as with an index of refraction of 0 in glTF.
scene::SurfaceParameters specularSurface(const MtlMaterial& m, const glm::vec3& specular) {
  scene::SurfaceParameters surface;
  surface.specularWeight = specular == glm::vec3(0) ? 0 : 1;
  surface.specularColour = specular;
  surface.ior = 0;
  surface.roughness = isMirror(m) ? 0 : roughnessOf(m.exponent.value_or(0));
  return surface;
}

void addSurface(const MtlMaterial& m, const MtlReferences& textures, const glm::vec3& diffuse,
                scene::Material& material) {
  const glm::vec3 absent(m.maps.contains(MapKind::specular) ? 1 : 0);
  const glm::vec3 specular = isMatt(m) ? glm::vec3(0) : limited(m.specular.value_or(absent));
  set(material, TextureSlot::baseColour, textures.diffuse);
  if (isPhysical(m)) {
    material.surface = physicalSurface(m, textures);
    set(material, TextureSlot::metallicRoughness, textures.metallicRoughness);
  } else if (specular == glm::vec3(0) && !textures.normal) {
    material.diffuse = scene::DiffuseLobe{.colour = diffuse};
    return;
  } else {
    material.surface = specularSurface(m, specular);
    if (specular != glm::vec3(0)) set(material, TextureSlot::specularColour, textures.specular);
  }
  material.surface->baseColour = diffuse;
  set(material, TextureSlot::normal, textures.normal);
  const bool isBump = !m.maps.contains(MapKind::normal) && m.maps.contains(MapKind::bump);
  if (textures.normal && isBump) material.normalScale = m.maps.at(MapKind::bump).bumpScale;
}

void addEmission(const MtlMaterial& m, const MtlReferences& textures, scene::Material& material) {
  material.emission = m.emission.value_or(glm::vec3(textures.emission ? 1 : 0));
  if (isEmissive(material)) set(material, TextureSlot::emission, textures.emission);
}

}  // namespace

scene::Material fromMtl(const MtlMaterial& m, const MtlReferences& textures, bool hasColours) {
  scene::Material material;
  addEmission(m, textures, material);
  if (isGlass(m) && !isPhysical(m)) {
    const float ior = m.ior && *m.ior > 0 ? *m.ior : kGlassIor;
    material.dielectric = scene::DielectricLobe{.colour = limited(m.filter.value_or(glm::vec3(1))), .ior = ior};
    material.opaque = false;
  } else {
    addSurface(m, textures, diffuseOf(m, hasColours), material);
    const float opacity = m.opacity.value_or(1);
    if (opacity < 1 || textures.opacity)
      material.opacity = scene::Opacity{.factor = opacity, .texture = textures.opacity};
  }
  return material;
}

}  // namespace candela::obj
