// The list of the numbers of nodes of the energy tables, by dimension.
#ifndef CANDELA_LISTS_ENERGY_TABLES_H
#define CANDELA_LISTS_ENERGY_TABLES_H

// X(number of nodes in candela::energy, number of cells between them in GLSL, number of nodes).
#define CANDELA_ENERGY_TABLES(X)                                       \
  X(kNodes, kEnergyCells, 48u) /* in each dimension */                 \
  X(kGlassCosines, kGlassCosineCells, 48u)                             \
  X(kGlassRoughnesses, kGlassRoughnessCells, 32u)                      \
  X(kGlassIors, kGlassIorCells, 11u)                                   \
  X(kSheenCosines, kSheenCosineCells, 32u)                             \
  X(kSheenRoughnesses, kSheenRoughnessCells, 32u)                      \
  X(kAnisotropicCosines, kAnisotropicCosineCells, 32u)                 \
  X(kAnisotropicAzimuths, kAnisotropicAzimuthCells, 12u)               \
  X(kAnisotropicRoughnesses, kAnisotropicRoughnessCells, 16u)          \
  X(kAnisotropicStrengths, kAnisotropicStrengthCells, 12u)             \
  X(kAnisotropicGlassCosines, kAnisotropicGlassCosineCells, 16u)       \
  X(kAnisotropicGlassAzimuths, kAnisotropicGlassAzimuthCells, 12u)     \
  X(kAnisotropicGlassRoughnesses, kAnisotropicGlassRoughnessCells, 8u) \
  X(kAnisotropicGlassStrengths, kAnisotropicGlassStrengthCells, 10u)   \
  X(kAnisotropicGlassIors, kAnisotropicGlassIorCells, 9u)

#endif
