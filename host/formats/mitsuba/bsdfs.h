// BSDFs as materials.
#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "host/formats/mitsuba/textures.h"
#include "host/scene/material.h"
#include "host/scene/plastic.h"

namespace candela::mitsuba {

struct Bsdf {
  /// Without emission. If `choices` are not empty, it has but the opacity of the surface and the texture of the weight.
  scene::Material material{};
  /// Two BSDFs, between which rays choose by `weight`, or by side without one.
  std::vector<Bsdf> choices{};
  std::optional<float> weight{};
  bool isInvisible = false;  ///< "null": light passes the surface as if it were not there
  bool isTwoSided = false;   ///< both sides scatter light alike; else the back is black. Not of `choices`
  /// Scales the colour, the opacity, or the weight of a choice; a mesh without it is white.
  std::optional<MeshAttribute> attribute{};
};

/// Calls `visit` with a BSDF, and with those between which it is a choice.
template <class Visit>
void forEachBsdf(Bsdf& bsdf, const Visit& visit) {
  visit(bsdf);
  for (Bsdf& choice : bsdf.choices) forEachBsdf(choice, visit);
}

/// Calls `visit` with each BSDF that is no choice between others.
template <class Visit>
void forEachLeaf(Bsdf& bsdf, const Visit& visit) {
  forEachBsdf(bsdf, [&](Bsdf& each) {
    if (each.choices.empty()) visit(each);
  });
}

/// Reads BSDFs, each once. Those that are not rendered are errors, or with `--lenient` replaced by others.
class Bsdfs {
 public:
  Bsdfs(Textures& textures, bool isOld, Report& report) : textures_(textures), isOld_(isOld), report_(report) {}

  /// `isOld`: the scene is one of Mitsuba 0.6, in which conductors are of copper by default. Throws PlacedError.
  const Bsdf& read(const Object& bsdf);

 private:
  static constexpr std::size_t kMaxPlastics = 256;

  Bsdf make(const Object& bsdf, int depth);
  Bsdf diffuse(const Object& bsdf);
  Bsdf dielectric(const Object& bsdf, double ior, scene::Interface shape);
  Bsdf roughDielectric(const Object& bsdf, double ior);
  Bsdf conductor(const Object& bsdf, bool isRough);
  Bsdf plastic(const Object& bsdf, bool isRough);
  const scene::Plastic& plasticOf(const Object& bsdf, scene::Interface boundary, float roughness, float ior,
                                  bool isNonlinear);
  Bsdf principled(const Object& bsdf);
  Bsdf twoSided(const Object& bsdf, int depth);
  Bsdf blend(const Object& bsdf, int depth);
  Bsdf blended(const Object& bsdf, int depth);
  Bsdf mask(const Object& bsdf, int depth);
  Bsdf normalMap(const Object& bsdf, int depth);
  Bsdf bumpMap(const Object& bsdf, int depth);
  Bsdf replaced(const Object& bsdf, const char* by, int depth);
  Bsdf nested(const Object& bsdf, int depth);

  void setOpacity(const Texture& opacity, const Object& bsdf, Bsdf& result);
  void setNormalMap(const Texture& map, float scale, bool hasHeights, const Object& bsdf, Bsdf& result);
  void setRoughness(const Object& bsdf, scene::Material& material);
  void putOnOneGrid(const Object& bsdf, std::span<Numbers> numbers);
  /// Sets the roughness and the anisotropy of a surface, and the texture that both and the metalness have. `texelAt`
  /// returns alpha along the tangent, alpha across it, and the metalness of a texel of `grid`, and `name` determines
  /// all of them.
  void setMicrofacets(const Object& bsdf, const Numbers& grid, const std::string& name,
                      const std::function<glm::dvec3(std::size_t)>& texelAt, scene::Material& material);
  scene::Interface distribution(const Object& bsdf);
  glm::dvec3 constant(const Object& bsdf, const char* name, double absent, ColourUse use);
  Texture baseColour(const Object& bsdf, const char* name, double absent, Bsdf& result);

  Textures& textures_;
  bool isOld_;
  Report& report_;
  std::map<const Object*, Bsdf> known_{};
  std::map<std::tuple<scene::Interface, float, float, bool>, scene::Plastic> plastics_{};
};

}  // namespace candela::mitsuba
