// Tables of branches, leaves and colours.
#include "host/scene/generate/tree_species.h"

namespace candela::generate {
namespace {

// count, from, lowAngle, highAngle, length, radius, taper, lift, wander, segments, sides, tipLength, middle
constexpr BranchLevel kOak[] = {{1, 0, 0, 0, 9.5, 0.36, 0.25, 0.1, 0.5, 9, 9, 1},
                                {15, 0.24, 80, 25, 4.6, 0.5, 0.25, 0.35, 0.7, 5, 5, 0.55, 0.25},
                                {7, 0.3, 60, 30, 1.9, 0.5, 0.3, 0.2, 0.8, 2, 3, 0.6}};
constexpr BranchLevel kBirch[] = {{1, 0, 0, 0, 12.5, 0.17, 0.15, 0.1, 0.3, 10, 8, 1},
                                  {22, 0.25, 55, 30, 2.9, 0.4, 0.3, 0.15, 0.4, 4, 4, 0.3, 0.2},
                                  {5, 0.35, 60, 40, 1.2, 0.5, 0.4, -0.9, 0.4, 2, 3, 0.7}};
constexpr BranchLevel kSpruce[] = {{1, 0, 0, 0, 16, 0.26, 0.06, 0, 0.08, 8, 8, 1},
                                   {150, 0.1, 108, 62, 3.1, 0.18, 0.3, 0.25, 0.15, 3, 3, 0.08, 0.06}};
constexpr BranchLevel kPine[] = {{1, 0, 0, 0, 13, 0.26, 0.35, 0.1, 0.35, 9, 8, 1},
                                 {16, 0.55, 85, 35, 2.9, 0.45, 0.3, 0.5, 0.6, 4, 5, 0.7, 0.25},
                                 {6, 0.4, 55, 30, 0.9, 0.5, 0.4, 0.6, 0.4, 2, 3, 0.8}};
constexpr BranchLevel kMaple[] = {{1, 0, 0, 0, 8.2, 0.24, 0.2, 0.1, 0.4, 8, 8, 1},
                                  {18, 0.22, 65, 20, 3.4, 0.45, 0.25, 0.45, 0.5, 4, 4, 0.5, 0.3},
                                  {6, 0.3, 55, 30, 1.4, 0.5, 0.3, 0.2, 0.6, 2, 3, 0.6}};

// count, from, length, width, spread, scatter, droop, fold
constexpr LeafStyle kOakLeaves{34, 0.1, 0.34, 0.24, 0.5, 0.7, 0.2, 0.15};
constexpr LeafStyle kBirchLeaves{32, 0, 0.22, 0.17, 0.25, 0.6, 0.6, 0.15};
constexpr LeafStyle kSpruceLeaves{24, 0.08, 0.62, 0.15, 0.05, 0.15, 0.35, 0.25};
constexpr LeafStyle kPineLeaves{36, 0.2, 0.34, 0.09, 0.22, 0.65, -0.2, 0.2};
constexpr LeafStyle kMapleLeaves{32, 0.05, 0.28, 0.27, 0.35, 0.7, 0.3, 0.15};

}  // namespace

const std::array<Plant, kSpeciesCount>& speciesModels() {
  static const std::array<Plant, kSpeciesCount> models{
      growPlant({kOak, kOakLeaves, 5.5}, 1), growPlant({kBirch, kBirchLeaves, 7.5}, 2),
      growPlant({kSpruce, kSpruceLeaves, 5}, 3), growPlant({kPine, kPineLeaves, 10}, 4),
      growPlant({kMaple, kMapleLeaves, 5}, 5)};
  return models;
}

const std::array<SpeciesColours, kSpeciesCount>& speciesColours() {
  static const std::array<SpeciesColours, kSpeciesCount> colours{{
      {{0.11, 0.08, 0.055}, {{{0.13, 0.21, 0.035}, {0.19, 0.24, 0.04}, {0.34, 0.24, 0.045}}}},
      {{0.62, 0.6, 0.55}, {{{0.28, 0.33, 0.06}, {0.55, 0.43, 0.06}, {0.64, 0.4, 0.05}}}},
      {{0.1, 0.07, 0.05}, {{{0.045, 0.105, 0.04}, {0.06, 0.125, 0.045}, {0.05, 0.11, 0.065}}}},
      {{0.27, 0.13, 0.07}, {{{0.09, 0.16, 0.05}, {0.12, 0.18, 0.055}, {0.085, 0.15, 0.07}}}},
      {{0.13, 0.1, 0.075}, {{{0.55, 0.16, 0.03}, {0.5, 0.07, 0.025}, {0.6, 0.3, 0.04}}}},
  }};
  return colours;
}

}  // namespace candela::generate
