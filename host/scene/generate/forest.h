// The places of everything that the forest shows.
#pragma once
#include <vector>

#include "host/scene/generate/lake_valley.h"
#include "host/scene/generate/tree_species.h"

namespace candela::generate {

struct Tree {
  MeshInstance place;
  Species species;
  std::size_t tint;  ///< of the leaves
};

/// Returns this many trees: those nearest to the lake. Smaller forests are parts of larger ones.
std::vector<Tree> plantTrees(const LakeValley& valley, std::uint32_t count);

/// Returns rocks on the shore and on the meadow.
std::vector<MeshInstance> placeRocks(const LakeValley& valley);
/// Returns tufts of grass in front of the camera.
std::vector<MeshInstance> placeTufts(const LakeValley& valley);

}  // namespace candela::generate
