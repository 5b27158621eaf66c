// Writes only the extensions that a material uses.
#include "host/scene/generate/gltf_material.h"

#include <algorithm>

namespace candela::generate {

GltfDocument::Json gltfMaterial(const MaterialFactors& factors) {
  const glm::dvec3& base = factors.colour;
  GltfDocument::Json material;
  material["pbrMetallicRoughness"] = {{"baseColorFactor", {base.x, base.y, base.z, 1}},
                                      {"metallicFactor", factors.metalness},
                                      {"roughnessFactor", factors.roughness}};
  GltfDocument::Json extensions;
  if (factors.transmission > 0) {
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", factors.transmission}};
  }
  if (factors.ior != 1.5) extensions["KHR_materials_ior"] = {{"ior", factors.ior}};
  if (factors.thickness > 0) extensions["KHR_materials_volume"] = {{"thicknessFactor", factors.thickness}};
  if (factors.thickness > 0 && factors.attenuationDistance > 0) {
    const glm::dvec3& left = factors.attenuation;
    extensions["KHR_materials_volume"]["attenuationColor"] = {left.x, left.y, left.z};
    extensions["KHR_materials_volume"]["attenuationDistance"] = factors.attenuationDistance;
  }
  if (factors.dispersion > 0) extensions["KHR_materials_dispersion"] = {{"dispersion", factors.dispersion}};
  if (factors.clearcoat > 0) {
    extensions["KHR_materials_clearcoat"] = {{"clearcoatFactor", factors.clearcoat},
                                             {"clearcoatRoughnessFactor", factors.clearcoatRoughness}};
  }
  if (factors.sheen != glm::dvec3(0)) {
    const glm::dvec3& sheen = factors.sheen;
    extensions["KHR_materials_sheen"] = {{"sheenColorFactor", {sheen.x, sheen.y, sheen.z}},
                                         {"sheenRoughnessFactor", factors.sheenRoughness}};
  }
  if (factors.film > 0) {
    extensions["KHR_materials_iridescence"] = {{"iridescenceFactor", factors.film},
                                               {"iridescenceThicknessMaximum", factors.filmThickness}};
  }
  if (factors.anisotropy > 0) {
    extensions["KHR_materials_anisotropy"] = {{"anisotropyStrength", factors.anisotropy},
                                              {"anisotropyRotation", factors.anisotropyRotation}};
  }
  if (factors.eta != glm::dvec3(0)) {
    const glm::dvec3 &eta = factors.eta, &kappa = factors.kappa;
    extensions["CANDELA_materials_conductor"] = {{"ior", {eta.x, eta.y, eta.z}},
                                                 {"extinction", {kappa.x, kappa.y, kappa.z}}};
  }
  if (factors.emission != glm::dvec3(0)) {
    const double strength = std::max({factors.emission.x, factors.emission.y, factors.emission.z});
    const glm::dvec3 colour = factors.emission / strength;  // a factor is at most 1
    material["emissiveFactor"] = {colour.x, colour.y, colour.z};
    extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
  }
  if (!extensions.empty()) material["extensions"] = extensions;
  return material;
}

}  // namespace candela::generate
