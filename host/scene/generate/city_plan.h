// The places of everything that the city shows.
#pragma once
#include <vector>

#include "host/scene/generate/building_models.h"

namespace candela::generate {

inline constexpr std::size_t kFacadeTints = 4;

struct BuildingPlace {
  MeshInstance place;
  Building building;
  std::size_t tint;  ///< of the facade
};

/// Blocks of six lots between streets, with an avenue along the z axis. The ground is at height 0; the roads are of
/// the height of the ground, and lots `kKerb` above it. Cars and trees are at the avenue and the streets around it.
struct CityPlan {
  static constexpr double kKerb = 0.15;
  static constexpr double kBlockWidth = 63, kBlockDepth = 44;

  std::vector<BuildingPlace> buildings;
  std::vector<MeshInstance> blocks;
  std::vector<MeshInstance> trees;
  std::vector<MeshInstance> cars;
  std::vector<MeshInstance> dashes;  ///< of the lines on the avenue
  double radius = 0;                 ///< of a circle around the origin that contains all blocks
};

/// Plans a city of this many buildings, those nearest to the centre. Smaller cities are parts of larger ones.
CityPlan planCity(std::uint32_t count);

}  // namespace candela::generate
