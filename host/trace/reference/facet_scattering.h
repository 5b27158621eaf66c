// Scattering by the facets of a normal map: docs/light-transport.md section 5.8. Directions are in the frame of the
// mapped normal.
#pragma once
#include <optional>

#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/normal_map.h"

namespace candela::reference {

/// Returns f times the cosine for `wi`, which is on this side of the geometric surface, with the light of other facets.
/// `facets`: nothing if the surface has no normal map.
BsdfValue scatteredValue(const Bsdf& bsdf, const std::optional<NormalMapFacets>& facets, const dvec3& wo,
                         const dvec3& wi, Side side);

/// Returns the direction of a sample of one facet, which is on its lobe's side of the facet, as it leaves the surface
/// on this side.
dvec3 leavingDirection(const std::optional<NormalMapFacets>& facets, const SurfaceSample& sample);

}  // namespace candela::reference
