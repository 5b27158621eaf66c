// The materials of glTF, as the file states them.
#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "host/formats/gltf/value.h"
#include "host/scene/surface_parameters.h"
#include "host/scene/texture.h"

namespace candela::gltf {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// The factors of a material, with the defaults of the specification (section 3.9 and its extensions).
struct GltfMaterial {
  glm::vec4 baseColour{1, 1, 1, 1};
  double metallic = 1;
  double roughness = 1;
  glm::vec3 emission{0, 0, 0};  ///< emissiveFactor times KHR_materials_emissive_strength
  std::optional<scene::TextureReference> baseColourTexture{};
  std::optional<scene::TextureReference> emissionTexture{};
  std::optional<scene::TextureReference> metallicRoughnessTexture{};
  std::optional<scene::TextureReference> glossinessTexture{};  ///< KHR_materials_pbrSpecularGlossiness
  std::optional<scene::TextureReference> specularTexture{};
  std::optional<scene::TextureReference> specularColourTexture{};
  std::optional<scene::TextureReference> normalTexture{};
  std::optional<scene::TextureReference> transmissionTexture{};
  std::optional<scene::TextureReference> clearcoatTexture{};
  std::optional<scene::TextureReference> clearcoatRoughnessTexture{};
  std::optional<scene::TextureReference> clearcoatNormalTexture{};
  double normalScale = 1;
  double clearcoatNormalScale = 1;
  std::optional<scene::TextureReference> sheenColourTexture{};
  std::optional<scene::TextureReference> sheenRoughnessTexture{};
  std::optional<scene::TextureReference> iridescenceTexture{};
  std::optional<scene::TextureReference> iridescenceThicknessTexture{};
  std::optional<scene::TextureReference> anisotropyTexture{};
  AlphaMode alphaMode = AlphaMode::opaque;
  double alphaCutoff = 0.5;  ///< of AlphaMode::mask
  bool isDoubleSided = false;
  bool isUnlit = false;                  ///< KHR_materials_unlit
  double ior = 1.5;                      ///< KHR_materials_ior; 0 or at least 1
  double specular = 1;                   ///< KHR_materials_specular
  glm::vec3 specularColour{1, 1, 1};     ///< KHR_materials_specular; may exceed 1
  double transmission = 0;               ///< KHR_materials_transmission
  double thickness = 0;                  ///< KHR_materials_volume; 0: a thin wall
  glm::vec3 attenuationColour{1, 1, 1};  ///< KHR_materials_volume
  double attenuationDistance = 0;        ///< KHR_materials_volume; 0: infinite
  double dispersion = 0;                 ///< KHR_materials_dispersion; 20 / Abbe number
  double clearcoat = 0;                  ///< KHR_materials_clearcoat
  double clearcoatRoughness = 0;         ///< KHR_materials_clearcoat
  glm::vec3 sheenColour{0, 0, 0};        ///< KHR_materials_sheen
  double sheenRoughness = 0;             ///< KHR_materials_sheen
  double iridescence = 0;                ///< KHR_materials_iridescence
  double iridescenceIor = 1.3;           ///< KHR_materials_iridescence; at least 1
  double iridescenceMinimum = 100;       ///< KHR_materials_iridescence; thickness in nanometres
  double iridescenceMaximum = 400;       ///< KHR_materials_iridescence; thickness in nanometres
  double anisotropy = 0;                 ///< KHR_materials_anisotropy; strength
  double anisotropyRotation = 0;         ///< KHR_materials_anisotropy; in radians
  /// CANDELA_materials_conductor, docs/gltf.md
  std::optional<scene::Conductor> conductor{};
  bool hasOcclusion = false;  ///< the file has an occlusion texture, which traced light does not need
  /// Extensions of the material that are not in this structure: "EXT_example".
  std::set<std::string> unread;
};

/// Reads a `textureInfo`, as Textures::read() does; nothing: the texture is left out.
using TextureReader = std::function<std::optional<scene::TextureReference>(const Value&)>;

/// Throws JsonError where a factor is missing or out of range, and the exceptions of `readTexture`.
GltfMaterial readMaterial(const Value& material, const TextureReader& readTexture);

}  // namespace candela::gltf
