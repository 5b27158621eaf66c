// Improves BVHs by reinsertion of subtrees.
#pragma once
#include <cstdint>

#include "host/trace/accel/bvh.h"

namespace candela::accel {

/// Removes subtrees from a valid BVH and reinserts each where the sum of the interior nodes' surface areas becomes
/// minimal (Bittner, Hapala and Havran, "Fast Insertion-Based Optimization of Bounding Volume Hierarchies", 2013), in
/// passes: all subtrees search for their positions in parallel, then those with the largest gain move first (Meister
/// and Bittner, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization", 2018). The leaves do not change, so
/// that the SAH cost never grows. Reinsertion::trunk restricts the search to the nodes with the largest surface areas.
/// Uses maxDepth, threads and reinsertion of `options`; the result does not depend on threads.
Bvh reinsert(Bvh bvh, const BvhOptions& options);

}  // namespace candela::accel
