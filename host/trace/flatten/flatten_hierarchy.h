// Builds a BVH and stores it as 16-byte records.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/trace/accel/bvh.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/flat_scene.h"

namespace candela::flatten {

/// Returns the layout in use: the one that is requested, or the choice of AutomaticChoices, except that BVHs with
/// midpoint splits are binary.
render::BvhLayout layoutFor(const render::RenderSettings& settings);

/// Returns the binary BVH over these boxes that the device traverses or, if `layout` is cwbvh, that is collapsed to an
/// 8-wide one. `layout` must not be automatic.
accel::Bvh buildHierarchy(std::span<const accel::Aabb> bounds, render::BvhSplit split, render::BuildQuality quality,
                          render::BvhLayout layout = render::BvhLayout::bvh2);

/// Builds the BVH over the finite primitives, appends its nodes to `flat`, and returns the indices of these primitives
/// in the order of its leaves.
std::vector<std::uint32_t> appendHierarchy(const accel::SceneBounds& bounds, const render::RenderSettings& settings,
                                           FlatScene& flat);

}  // namespace candela::flatten
