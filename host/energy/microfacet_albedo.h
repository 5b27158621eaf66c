// The energy that a rough surface reflects once: docs/light-transport.md section 5.3.
#pragma once

namespace candela::energy {

/// Directional albedos of a GGX surface with height-correlated masking and shadowing, without multiple scattering.
struct MicrofacetAlbedo {
  double white;    ///< with a reflectance of 1, in (0, 1]
  double grazing;  ///< with the reflectance (1 - wo.h)^5, in [0, white]
};

/// Integrates over the sampled half vectors with `rings` by `spokes` midpoints. `cosine` in [0, 1] is that of wo,
/// `alpha` in (0, 1]. With 256 by 128 points the error is below 1e-4.
MicrofacetAlbedo integrateMicrofacets(double cosine, double alpha, int rings = 256, int spokes = 128);

}  // namespace candela::energy
