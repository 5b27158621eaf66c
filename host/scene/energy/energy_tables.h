// Tables of the energy that rough surfaces reflect, for both tracers: docs/light-transport.md section 5.3.
#pragma once
#include <array>
#include <cstddef>

#include "lists/energy_tables.h"

namespace candela::energy {

// Numbers of nodes of all tables, by dimension.
#define CANDELA_DECLARE_NODES(nodes, cells, count) inline constexpr std::size_t nodes = count;
CANDELA_ENERGY_TABLES(CANDELA_DECLARE_NODES)
#undef CANDELA_DECLARE_NODES

/// Smallest roughness: smaller values are raised to it. alpha is the square of the roughness.
inline constexpr double kMinRoughness = 0.01;

/// A table of two dimensions, both over [0, 1]: node (i, j) has the index j * kNodes + i, belongs to the roughness
/// rho = max(j / (kNodes - 1), kMinRoughness) and to the cosine at which c (1 + alpha) / (c + alpha) is
/// i / (kNodes - 1).
using Table = std::array<float, kNodes * kNodes>;

/// Directional albedo of white microfacets that reflect once.
extern const Table kWhite;
/// The mean of (1 - wo.h)^5 over that light is (1 - c - alpha t)^5 with the value t of this table.
extern const Table kTilt;

/// A table of glass, whose first two dimensions are those above; node (i, j, k) has the index
/// (k * kGlassRoughnesses + j) * kGlassCosines + i. The indices of refraction n are those at which (n - 1)/(n + 1) is
/// k / 2 / (kGlassIors - 1), but at least kMinVolumeIor.
inline constexpr double kMinVolumeIor = 1.01;
using GlassTable = std::array<float, kGlassCosines * kGlassRoughnesses * kGlassIors>;

/// Directional albedo of rough glass that reflects or transmits once, seen from outside and from inside. Nodes are
/// raised where interpolation would fall short of the albedo in the middle of a cell, since glass would gain energy
/// there, and by 0.1 % everywhere, since quadrature falls short, too.
extern const GlassTable kGlassOutside;
extern const GlassTable kGlassInside;

/// Smallest roughness of a sheen: smaller values are raised to it.
inline constexpr double kMinSheenRoughness = 0.07;

/// A table of a sheen: node (i, j) has the index j * kSheenCosines + i, belongs to the roughness
/// rho = max(j / (kSheenRoughnesses - 1), kMinSheenRoughness) and to the cosine at which c (1 + rho) / (c + rho) is
/// (i / (kSheenCosines - 1))^2.
using SheenTable = std::array<float, kSheenCosines * kSheenRoughnesses>;

/// Directional albedo of a white sheen, times rho / (0.198 + 0.24 rho).
extern const SheenTable kSheen;

}  // namespace candela::energy
