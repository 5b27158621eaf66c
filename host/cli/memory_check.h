// Refuses renders that cannot fit into memory, before the machine begins to swap.
#pragma once
#include <cstdint>

#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::cli {

/// Throws OutOfMemoryError, with the sizes, if the film or the scene with its acceleration structure needs more than
/// `present` bytes.
void requireMemory(const scene::Scene& scene, const render::RenderSettings& settings, std::uint64_t present);

}  // namespace candela::cli
