// Tables of the energy that anisotropic microfacets reflect, for both tracers: docs/light-transport.md section 5.12.
#pragma once
#include <array>
#include <cstddef>

namespace candela::energy {

/// Nodes of a table in its four dimensions: node (i, j, k, l) has the index
/// ((l * kGrainRoughnesses + k) * kGrainAzimuths + j) * kGrainCosines + i. It belongs to the roughness
/// max(k / (kGrainRoughnesses - 1), kMinRoughness), whose square is ab, to the strength l / (kGrainStrengths - 1), and
/// thereby to at = mix(ab, 1, strength^2); to the azimuth at which (av - ab) / (at - ab) is (j / (kGrainAzimuths -
/// 1))^2, where av is alpha in the direction of wo; and to the cosine c at which c (1 + a) / (c + a) is
/// i / (kGrainCosines - 1), with a = av for kGrainWhite and a = at for kGrainTilt.
inline constexpr std::size_t kGrainCosines = 32, kGrainAzimuths = 12, kGrainRoughnesses = 16, kGrainStrengths = 12;
using GrainTable = std::array<float, kGrainCosines * kGrainAzimuths * kGrainRoughnesses * kGrainStrengths>;

/// Directional albedo of white anisotropic microfacets that reflect once, raised where interpolation would fall short
/// of it in the middle of a cell, and by 0.1 % everywhere.
extern const GrainTable kGrainWhite;
/// The mean of (1 - wo.h)^5 over that light is (1 - c - at t)^5 with the value t of this table, which is lowered
/// where interpolation would exceed it in the middle of a cell.
extern const GrainTable kGrainTilt;

/// Nodes of the tables of anisotropic glass. The first four dimensions are those above, with a = av. The fifth has the
/// indices of refraction n at which (n - 1)/(n + 1) is (m / (kGrainGlassIors - 1))^2 / 2, but at least kMinVolumeIor.
inline constexpr std::size_t kGrainGlassCosines = 16, kGrainGlassAzimuths = 12, kGrainGlassRoughnesses = 8,
                             kGrainGlassStrengths = 10, kGrainGlassIors = 9;
using GrainGlassTable = std::array<float, kGrainGlassCosines * kGrainGlassAzimuths * kGrainGlassRoughnesses *
                                              kGrainGlassStrengths * kGrainGlassIors>;

/// Directional albedo of rough anisotropic glass that reflects or transmits once, seen from outside and from inside.
/// Nodes are raised where interpolation would fall short of it at four points of a cell, and by 0.1 % everywhere.
extern const GrainGlassTable kGrainGlassOutside;
extern const GrainGlassTable kGrainGlassInside;

}  // namespace candela::energy
