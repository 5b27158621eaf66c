// Improves built trees by reinsertion.
#pragma once
#include <cstdint>

#include "host/accel/bvh.h"

namespace candela::accel {

/// Takes subtrees out of a valid tree and puts each back where the sum of the inner nodes' surfaces becomes least
/// (Bittner, Hapala and Havran, "Fast Insertion-Based Optimization of Bounding Volume Hierarchies", 2013), in passes:
/// all look for their places in parallel, then those that gain most move first (Meister and Bittner, "Parallel
/// Reinsertion for Bounding Volume Hierarchy Optimization", 2018). The leaves stay as they are, so that the SAH cost
/// never grows. With Reinsertion::trunk only among the nodes of the largest surfaces. Reads maxDepth, threads and
/// reinsertion of `options`; a function of the tree and of the other two alone.
Bvh reinsert(Bvh bvh, const BvhOptions& options);

}  // namespace candela::accel
