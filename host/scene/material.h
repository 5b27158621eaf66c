// Materials, which determine how surfaces scatter and emit light, for the path tracer and for the Whitted tracer:
// docs/light-transport.md sections 5 and 9. Every file format has one function that derives a material from its own
// statements (nff_material.h); tracers use nothing else.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "host/scene/surface_parameters.h"
#include "host/scene/texture.h"

namespace candela::scene {

/// Lambertian reflection.
struct DiffuseLobe {
  double weight = 1;  ///< > 0
  glm::vec3 colour{1, 1, 1};

  bool operator==(const DiffuseLobe&) const = default;
};

/// Blinn-Phong, with Torrance and Sparrow's shadowing and masking.
struct GlossyLobe {
  double weight = 1;  ///< > 0
  glm::vec3 colour{1, 1, 1};
  float exponent = 1;  ///< >= 0

  bool operator==(const GlossyLobe&) const = default;
};

/// A smooth boundary between two dielectrics.
struct DielectricLobe {
  double weight = 1;  ///< > 0
  glm::vec3 colour{1, 1, 1};
  float ior = 1;  ///< > 0, index of the inside relative to the outside

  bool operator==(const DielectricLobe&) const = default;
};

struct MirrorLobe {
  glm::vec3 colour{1, 1, 1};

  bool operator==(const MirrorLobe&) const = default;
};

/// The rays that the Whitted tracer spawns at a surface.
enum class WhittedKind : std::uint8_t { opaque, mirror, glass };

/// The coefficients of the Whitted tracer. Only NFF and P3F state them.
struct WhittedMaterial {
  WhittedKind kind = WhittedKind::opaque;
  glm::vec3 diffuse{1, 1, 1};
  float kd = 0;  ///< diffuse reflection of light from point lights
  float ka = 0;  ///< ambient light, with the diffuse colour
  glm::vec3 specular{1, 1, 1};
  float ks = 0;     ///< highlights of point lights, and the factor of a mirror
  float shine = 1;  ///< exponent of the highlights, >= 0
  float ior = 1;    ///< > 0 if `kind` is glass

  bool operator==(const WhittedMaterial&) const = default;
};

/// The opacity of a surface, which is determined by the alpha at a point: the product of `factor`, of the texture's
/// alpha and of the vertex colours' alpha. Rays that do not hit pass the surface as if it were not there.
struct Opacity {
  float factor = 1;                           ///< 0 to 1
  std::optional<float> cutoff{};              ///< rays hit where alpha is at least this; empty: with probability alpha
  std::optional<TextureReference> texture{};  ///< of which only alpha is used

  bool operator==(const Opacity&) const = default;
};

/// The two materials of which rays that arrive at a surface see one: docs/light-transport.md section 5.16.
struct MaterialChoice {
  std::uint32_t first = 0;  ///< index in Scene::materials
  std::uint32_t second = 0;
  /// The probability of the second material, in [0, 1], is this factor times the alpha of the base colour's texture and
  /// of the vertex colours. Empty: the first material is that of the front, the second that of the back.
  std::optional<float> weight{};

  bool operator==(const MaterialChoice&) const = default;
};

/// Either `surface`, or `choice`, or lobes, at most one of each kind; a material with none of them is black. The lobes'
/// weights sum to at most 1, except for rounding. A mirror lobe is the only lobe of its material. Of a choice, opacity
/// and emission are those of the whole surface, and both materials have the same emission. The materials of a
/// choice by weight may be choices by side, or the other way round, but no more.
struct Material {
  std::optional<SurfaceParameters> surface;
  std::optional<MaterialChoice> choice;
  std::optional<DiffuseLobe> diffuse;
  std::optional<GlossyLobe> glossy;
  std::optional<DielectricLobe> dielectric;
  std::optional<MirrorLobe> mirror;
  bool coloursScaleEmission = false;       ///< vertex colours are factors of the emission
  glm::vec3 emission{0, 0, 0};             ///< radiance, W/(sr m^2) in arbitrary units, >= 0
  bool opaque = true;                      ///< with `--one-sided`, the backs of its triangles and planes are not hit
  std::optional<WhittedMaterial> whitted;  ///< empty: the Whitted tracer cannot show the material
  /// By TextureSlot. The base colour scales the colours of all lobes, emission the emission.
  std::array<std::optional<TextureReference>, kTextureSlotCount> textures{};
  float normalScale = 1;  ///< factor of the first two components of the normal map's directions
  /// The normal map is a bump map: the red of its texels times normalScale is a height, in units of the scene.
  bool hasHeights = false;
  /// Facets close the surface that normal maps tilt, so that no light is lost; else normals are simply replaced.
  bool hasFacets = true;
  float coatNormalScale = 1;         ///< of those of the coat's normal map
  std::optional<Opacity> opacity{};  ///< empty: every ray hits; only triangles have one

  bool operator==(const Material&) const = default;
};

/// Returns whether the material emits.
inline bool isEmissive(const Material& material) {
  return material.emission.x > 0 || material.emission.y > 0 || material.emission.z > 0;
}

/// Returns whether rays of the path tracer may cross a surface of the material.
inline bool transmits(const Material& material) {
  return material.dielectric || (material.surface && material.surface->transmissionWeight > 0);
}

inline const std::optional<TextureReference>& textureOf(const Material& material, TextureSlot slot) {
  return material.textures[static_cast<std::size_t>(slot)];
}

inline bool isTextured(const Material& material) {
  return std::ranges::any_of(material.textures, [](const auto& texture) { return texture.has_value(); });
}

/// Returns whether the material, or its coat, has a normal map.
inline bool hasNormalMap(const Material& material) {
  return textureOf(material, TextureSlot::normal) || textureOf(material, TextureSlot::coatNormal);
}

/// Returns whether microfacets of the material are rougher in one direction than in the other.
inline bool isAnisotropic(const Material& material) { return material.surface && material.surface->anisotropy > 0; }

/// Returns the texture along whose coordinates the tangents of a mesh run; nothing if the material depends on no
/// tangent. Meshes that state no tangents get those of mikkTangents(). An anisotropic material without textures has the
/// tangents of the first set of texture coordinates.
inline const std::optional<TextureReference>& tangentTextureOf(const Material& material) {
  static const std::optional<TextureReference> kFirstSet{TextureReference{}};
  for (const TextureSlot slot : {TextureSlot::normal, TextureSlot::coatNormal, TextureSlot::anisotropy}) {
    if (textureOf(material, slot)) return textureOf(material, slot);
  }
  return isAnisotropic(material) ? kFirstSet : textureOf(material, TextureSlot::anisotropy);
}

/// The name of a material with one lobe is that of the lobe. `surface`: the material has SurfaceParameters.
enum class MaterialKind : std::uint8_t { black, diffuse, glossy, dielectric, mirror, mixture, surface, choice };

MaterialKind kindOf(const Material& material);

}  // namespace candela::scene
