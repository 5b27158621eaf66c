// Boxes as a scene: their edges as thin cylinders.
#pragma once
#include <span>

#include "host/accel/bvh_levels.h"
#include "host/generate/nff_writer.h"
#include "host/scene/scene.h"

namespace candela::cli {

/// Primitives that a box becomes, at most: the others' edges have no length.
inline constexpr std::uint64_t kBoxEdges = 12;

/// The view of `camera` without its lens, a light at the eye, so that both tracers see the edges, and no background.
/// Edges are as thick as 1/250 of the picture's height where the camera looks at, and coloured by depth from pale
/// yellow (the root) to purple (`deepest`, in steps from the root).
void writeBoxScene(generate::NffWriter& out, const scene::Camera& camera, std::span<const accel::LevelBox> boxes,
                   std::uint32_t deepest);

}  // namespace candela::cli
