// The buildings of the city, with windows, balconies, cornices and roofs as geometry.
#pragma once
#include <array>

#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

enum class Building { house, flats, office, setbacks, tower };
inline constexpr std::size_t kBuildingCount = 5;

/// The materials of which a building consists, apart from each other.
enum class BuildingPart { wall, trim, glass, roof };
inline constexpr std::size_t kBuildingPartCount = 4;

/// Parts are indexed by BuildingPart. A building stands on the square of 18 m around the origin.
using BuildingModel = std::array<TriangleMesh, kBuildingPartCount>;

/// Returns the models, indexed by Building.
const std::array<BuildingModel, kBuildingCount>& buildingModels();

/// Returns a car of 4.3 m along the x axis: its body, and its windows and wheels.
std::array<TriangleMesh, 2> carModel();

}  // namespace candela::generate
