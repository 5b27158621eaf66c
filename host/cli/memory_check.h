// Refuses renders that cannot fit into memory, before the machine begins to swap.
#pragma once
#include <cstdint>

#include "host/scene/scene.h"

namespace candela::cli {

/// Throws OutOfMemoryError, with the sizes, if the scene with its acceleration structure needs more than `present`
/// bytes.
void requireMemoryForScene(const scene::Scene& scene, std::uint64_t present);

}  // namespace candela::cli
