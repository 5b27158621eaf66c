// The energy that a rough surface reflects once: docs/light-transport.md section 5.3.
#pragma once
#include <span>

#include "host/scene/energy/boundary.h"

namespace candela::energy {

/// Directional albedos of a GGX surface with height-correlated masking and shadowing, without multiple scattering.
struct MicrofacetAlbedo {
  double white;    ///< with a reflectance of 1, in (0, 1]
  double grazing;  ///< with the reflectance (1 - wo.h)^5, in [0, white]
};

/// Integrates over the sampled half vectors with `rings` by `spokes` midpoints. `cosine` in [0, 1] is that of wo,
/// `alpha` in (0, 1]. With 256 by 128 points the error is below 1e-4.
MicrofacetAlbedo integrateMicrofacets(double cosine, double alpha, int rings = 256, int spokes = 128);

/// Computes, for each of `boundaries`, the fraction of light that microfacets of glass, with Schlick's reflectance,
/// reflect or transmit to the side where it belongs. `albedos` has as many elements.
void integrateGlass(double cosine, double alpha, const Boundaries<double>& boundaries, std::span<double> albedos,
                    int rings = 96, int spokes = 64);

}  // namespace candela::energy
