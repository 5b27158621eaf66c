// Rows of the BVH.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/primitive_bounds.h"
#include "host/flatten/flat_scene.h"

namespace candela::flatten {

/// The layout in use: the one that is asked for, or where that is automatic what AutomaticChoices says, but two-wide
/// nodes for the report's trees, which are two-wide.
render::BvhLayout layoutFor(const render::RenderSettings& settings);

/// As on the command line: "fast", "default" or "high".
const char* buildQualityName(render::BuildQuality quality);

/// The two-wide tree that the device's tracers traverse for such boxes or, of layout cwbvh, that is collapsed to an
/// eight-wide one; `layout` is one of both.
accel::Bvh buildHierarchy(std::span<const accel::Aabb> bounds, render::BvhSplit split, render::BuildQuality quality,
                          render::BvhLayout layout = render::BvhLayout::bvh2);

/// Builds the hierarchy over the finite primitives, appends its nodes to `flat`, and returns these primitives' indices
/// in the order of its leaves.
std::vector<std::uint32_t> appendHierarchy(const accel::SceneBounds& bounds, const render::RenderSettings& settings,
                                           FlatScene& flat);

}  // namespace candela::flatten
