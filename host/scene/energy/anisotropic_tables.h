// Tables of the energy that anisotropic microfacets reflect, for both tracers: docs/light-transport.md section 5.12.
#pragma once
#include <array>
#include <cstddef>

#include "host/scene/energy/energy_tables.h"

namespace candela::energy {

/// A table of four dimensions: node (i, j, k, l) has the index
/// ((l * kAnisotropicRoughnesses + k) * kAnisotropicAzimuths + j) * kAnisotropicCosines + i. It belongs to the
/// roughness max(k / (kAnisotropicRoughnesses - 1), kMinRoughness), whose square is ab, to the strength l /
/// (kAnisotropicStrengths - 1), and thereby to at = mix(ab, 1, strength^2); to the azimuth at which (av - ab) / (at -
/// ab) is (j / (kAnisotropicAzimuths - 1))^2, where av is alpha in the direction of wo; and to the cosine c at which c
/// (1 + a) / (c + a) is i / (kAnisotropicCosines - 1), with a = av for kAnisotropicWhite and a = at for
/// kAnisotropicTilt.
using AnisotropicTable = std::array<float, kAnisotropicCosines * kAnisotropicAzimuths * kAnisotropicRoughnesses *
                                               kAnisotropicStrengths>;

/// Directional albedo of white anisotropic microfacets that reflect once, raised where interpolation would fall short
/// of it in the middle of a cell, and by 0.1 % everywhere.
extern const AnisotropicTable kAnisotropicWhite;
/// The mean of (1 - wo.h)^5 over that light is (1 - c - at t)^5 with the value t of this table, which is lowered
/// where interpolation would exceed it in the middle of a cell.
extern const AnisotropicTable kAnisotropicTilt;

/// A table of anisotropic glass. The first four dimensions are those above, with a = av. The fifth has the indices of
/// refraction n at which (n - 1)/(n + 1) is (m / (kAnisotropicGlassIors - 1))^2 / 2, but at least
/// kMinVolumeIor.
using AnisotropicGlassTable = std::array<float, kAnisotropicGlassCosines * kAnisotropicGlassAzimuths *
                                                    kAnisotropicGlassRoughnesses * kAnisotropicGlassStrengths *
                                                    kAnisotropicGlassIors>;

/// Directional albedo of rough anisotropic glass that reflects or transmits once, seen from outside and from inside.
/// Nodes are raised where interpolation would fall short of it at four points of a cell, and by 0.1 % everywhere.
extern const AnisotropicGlassTable kAnisotropicGlassOutside;
extern const AnisotropicGlassTable kAnisotropicGlassInside;

}  // namespace candela::energy
