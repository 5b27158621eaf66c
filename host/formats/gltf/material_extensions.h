// The extensions of materials: https://github.com/KhronosGroup/glTF/tree/main/extensions. A material without an
// extension keeps the defaults of GltfMaterial. All functions throw JsonError where a factor is wrong.
#pragma once
#include "host/formats/gltf/gltf_material.h"

namespace candela::gltf {
/// KHR_materials_specular.
void readSpecular(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// KHR_materials_ior, KHR_materials_transmission and KHR_materials_volume.
void readTransmission(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// KHR_materials_dispersion.
void readDispersion(const Value& material, GltfMaterial& result);
/// KHR_materials_clearcoat.
void readClearcoat(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// KHR_materials_sheen.
void readSheen(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// KHR_materials_iridescence.
void readIridescence(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// KHR_materials_anisotropy.
void readAnisotropy(const Value& material, const TextureReader& readTexture, GltfMaterial& result);
/// CANDELA_materials_conductor: docs/gltf.md.
void readConductor(const Value& material, GltfMaterial& result);

}  // namespace candela::gltf
