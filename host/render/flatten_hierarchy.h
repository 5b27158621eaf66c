// Rows of the BVH.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/accel/bvh.h"
#include "host/accel/primitive_bounds.h"
#include "host/render/flat_scene.h"

namespace candela {

/// The tree that the device's tracers traverse for such boxes. A single leaf where testing all primitives is faster.
Bvh buildHierarchy(std::span<const Aabb> bounds, BvhSplit split);

/// Builds the hierarchy over the finite primitives, appends its nodes to `flat`, and returns these primitives' indices
/// in the order of its leaves.
std::vector<std::uint32_t> appendHierarchy(const SceneBounds& bounds, BvhSplit split, FlatScene& flat);

}  // namespace candela
