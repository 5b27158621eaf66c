// Boxes as a scene: their edges are thin cylinders.
#pragma once
#include <span>

#include "host/scene/generate/nff_writer.h"
#include "host/scene/scene.h"
#include "host/trace/accel/bvh_levels.h"

namespace candela::cli {

/// Maximum number of primitives per box. Edges without length are omitted.
inline constexpr std::uint64_t kBoxEdges = 12;

/// Writes a scene with the view of `camera` but without its lens, with a light at the eye, so that both tracers show
/// the edges, and with a black background. The thickness of edges is 1/250 of the height of the picture at the point
/// looked at. Their colours depend on the depth, from pale yellow (the root) to purple (`deepest`, in steps from the
/// root).
void writeBoxScene(generate::NffWriter& out, const scene::Camera& camera, std::span<const accel::LevelBox> boxes,
                   std::uint32_t deepest);

}  // namespace candela::cli
