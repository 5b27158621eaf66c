// Rows of the BVH.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/primitive_bounds.h"
#include "host/render/flat_scene.h"

namespace candela {

/// The layout in use: the one that is asked for, or where that is automatic what AutomaticChoices says, but two-wide
/// nodes for the report's trees, which are two-wide.
BvhLayout layoutFor(const RenderSettings& settings);

/// As on the command line: "fast", "default" or "high".
const char* buildQualityName(BuildQuality quality);

/// The two-wide tree that the device's tracers traverse for such boxes or, of layout cwbvh, that is collapsed to an
/// eight-wide one; `layout` is one of both.
Bvh buildHierarchy(std::span<const Aabb> bounds, BvhSplit split, BuildQuality quality,
                   BvhLayout layout = BvhLayout::bvh2);

/// Builds the hierarchy over the finite primitives, appends its nodes to `flat`, and returns these primitives' indices
/// in the order of its leaves.
std::vector<std::uint32_t> appendHierarchy(const SceneBounds& bounds, const RenderSettings& settings, FlatScene& flat);

}  // namespace candela
