// Computes the depth of each node from that of its parent.
#include "host/trace/accel/bvh_levels.h"

namespace candela::accel {

std::vector<LevelBox> levelBoxes(const Bvh& bvh, std::optional<std::uint32_t> level) {
  std::vector<std::uint32_t> depths(bvh.nodes.size(), 0);
  std::vector<LevelBox> boxes;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
    const BvhNode& node = bvh.nodes[i];
    const std::uint32_t depth = depths[i];
    if (!node.isLeaf()) depths[node.first] = depths[node.first + 1] = depth + 1;
    if (!level || depth == *level || (depth < *level && node.isLeaf())) boxes.push_back({node.bounds, depth});
  }
  return boxes;
}

}  // namespace candela::accel
