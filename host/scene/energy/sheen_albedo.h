// The energy that the fibres of a sheen scatter: docs/light-transport.md section 5.9.
#pragma once

namespace candela::energy {

/// Returns the directional albedo of a white sheen. `cosine` in [0, 1] is that of wo; `alpha`, in (0, 1], is the square
/// of the sheen's roughness. Integrates over `rings` by `spokes` midpoints of the hemisphere, denser towards the
/// horizon.
double integrateSheen(double cosine, double alpha, int rings = 256, int spokes = 64);

}  // namespace candela::energy
