// Stores an 8-wide BVH as 16-byte records.
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

constexpr int kExponentBias = 127;

// Packs the indices of four planes, from child `first` on, a byte each.
std::uint32_t fourPlanes(const std::array<std::uint8_t, accel::kWideChildren>& planes, std::uint32_t first) {
  std::uint32_t word = 0;
  for (std::uint32_t i = 0; i < 4; ++i) word |= std::uint32_t{planes[first + i]} << (8 * i);
  return word;
}

gpu::uvec4 planeRow(const std::array<std::uint8_t, accel::kWideChildren>& a,
                    const std::array<std::uint8_t, accel::kWideChildren>& b) {
  return {fourPlanes(a, 0), fourPlanes(a, 4), fourPlanes(b, 0), fourPlanes(b, 4)};
}

std::uint32_t exponentsAndMask(const accel::WideNode& node) {
  std::uint32_t word = std::uint32_t{node.innerMask} << 24;
  for (int axis = 0; axis < 3; ++axis) {
    word |= static_cast<std::uint32_t>(node.boxes.exponent[axis] + kExponentBias) << (8 * axis);
  }
  return word;
}

}  // namespace

void appendWideNodes(const accel::WideBvh& wide, Rows& rows) {
  rows.reserve(rows.size() + wide.nodes.size() * gpu::kWideNodeRows);
  for (const accel::WideNode& node : wide.nodes) {
    const accel::QuantisedBoxes& boxes = node.boxes;
    rows.push_back(row(glm::dvec3(boxes.origin), exponentsAndMask(node)));
    rows.push_back({node.block, node.firstPrimitive, node.leafMask, 0});
    rows.push_back(planeRow(boxes.low[0], boxes.low[1]));
    rows.push_back(planeRow(boxes.low[2], boxes.high[0]));
    rows.push_back(planeRow(boxes.high[1], boxes.high[2]));
  }
}

}  // namespace candela::flatten
