// Materials of glTF, as tests write them, and the materials of the scene that they become.
#pragma once
#include "host/formats/gltf/material_mapping.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {

/// A reference whose image is the index of the texture.
inline scene::TextureReference textureOfIndex(const Value& info) {
  return {.image = static_cast<std::uint32_t>(info.require("index").whole())};
}

inline scene::Material mapped(const json& material) {
  return fromGltf(readMaterial(Value(material, "/materials/0"), textureOfIndex));
}

inline const scene::TextureReference kTexture7{.image = 7};

inline json metallicRoughness(double metallic, double roughness) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}}}};
}

inline const glm::vec3 kBase{0.5f, 0.25f, 1};

}  // namespace candela::gltf
