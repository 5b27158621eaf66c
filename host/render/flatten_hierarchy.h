// Rows of the BVH.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/primitive_bounds.h"
#include "host/render/flat_scene.h"

namespace candela {

/// The layout in use: `asked`, or where that is automatic the faster one (docs/performance.md), but two-wide nodes for the
/// report's trees, which are two-wide.
BvhLayout layoutFor(BvhLayout asked, BvhSplit split);

/// As on the command line: "fast", "default" or "high".
const char* buildQualityName(BuildQuality quality);

/// The two-wide tree that the device's tracers traverse for such boxes or, of layout cwbvh, that is collapsed to an
/// eight-wide one. A single leaf where testing all primitives is faster.
Bvh buildHierarchy(std::span<const Aabb> bounds, BvhSplit split, BuildQuality quality,
                   BvhLayout layout = BvhLayout::bvh2);

/// Builds the hierarchy over the finite primitives, appends its nodes to `flat`, and returns these primitives' indices
/// in the order of its leaves.
std::vector<std::uint32_t> appendHierarchy(const SceneBounds& bounds, const RenderSettings& settings, FlatScene& flat);

}  // namespace candela
