// The energy that anisotropic microfacets reflect once: docs/light-transport.md section 5.12.
#pragma once
#include <glm/glm.hpp>

#include "host/energy/microfacet_albedo.h"

namespace candela::energy {

/// Integrates over the visible normals with the points of a lattice. `cosine` in [0, 1] is that of wo, `cosSquared` the
/// squared cosine of its azimuth to the x axis, `alpha` the roughness along x and y, in (0, 1]. The relative error is
/// below 0.1 %.
MicrofacetAlbedo integrateGrain(double cosine, double cosSquared, const glm::dvec2& alpha);

}  // namespace candela::energy
