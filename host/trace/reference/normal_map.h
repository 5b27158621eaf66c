// Normal maps: docs/light-transport.md section 5.8.
#pragma once
#include <algorithm>

#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/textured_material.h"

namespace candela::reference {

/// Replaces the shading normal of a surface, at which a ray of this direction arrives, by that of a normal map of its
/// material, if there is one in the slot.
void applyNormalMap(const TextureReader& textures, scene::TextureSlot slot, const dvec3& rayDirection,
                    Surface& surface);

/// Returns the fraction of the light from `wi` that the bumps of a normal map without facets do not shadow (Conty
/// Estevez, Lecocq and Stein, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator Problem", 2019).
double bumpShadowing(const dvec3& mapped, const dvec3& unmapped, const dvec3& wi);

/// The facets of a normal map, in the frame of the mapped normal.
class NormalMapFacets {
 public:
  /// `geometric`: the geometric normal on the side of the ray.
  explicit NormalMapFacets(const dvec3& geometric) : geometric_(geometric) {}

  /// Returns the probability that a ray from `wo` hits the mapped facet directly.
  double directProbability(const dvec3& wo) const;
  /// Returns `wo` as a facet sees it by reflection in its perpendicular neighbour.
  dvec3 seenByReflection(const dvec3& wo) const;
  /// Returns a direction's reflection at the geometric surface.
  dvec3 mirrored(const dvec3& w) const { return w - 2 * dot(w, geometric_) * geometric_; }
  /// Returns a direction of the diffuse lobe below the surface as it is scattered again, by the cosine to the geometric
  /// normal.
  dvec3 scatteredAgain(const dvec3& w) const;
  double geometricCosine(const dvec3& wi) const { return std::max(0.0, dot(wi, geometric_)); }
  /// Returns the factor of the diffuse lobe, in the place of a cosine, for light from `wi` by other facets.
  double cosineByOthers(const dvec3& wi) const { return sunkFraction() * geometricCosine(wi); }
  bool isOn(Side side, const dvec3& w) const { return (dot(w, geometric_) > 0) == (side == Side::reflection); }

 private:
  /// The normal of the mapped facet without its part along the geometric normal.
  dvec3 tilt() const { return dvec3(0, 0, 1) - geometric_.z * geometric_; }

  /// The fraction of a cosine lobe about the mapped normal that is below the surface.
  double sunkFraction() const { return dot(dvec2(geometric_), dvec2(geometric_)) / (2 + 2 * geometric_.z); }

  dvec3 geometric_;
};

}  // namespace candela::reference
