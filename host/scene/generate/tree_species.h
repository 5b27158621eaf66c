// The species of the forest.
#pragma once
#include <array>
#include <span>

#include "host/scene/generate/plant_growth.h"

namespace candela::generate {

enum class Species { oak, birch, spruce, pine, maple };
inline constexpr std::size_t kSpeciesCount = 5;
inline constexpr std::size_t kTintCount = 3;

/// Colours are linear.
struct SpeciesColours {
  glm::dvec3 bark;
  std::array<glm::dvec3, kTintCount> leaves;
};

/// Returns the models and colours, indexed by Species. Models are grown once.
const std::array<Plant, kSpeciesCount>& speciesModels();
const std::array<SpeciesColours, kSpeciesCount>& speciesColours();

}  // namespace candela::generate
