// Builds a binary BVH and stores it as 16-byte records.
#include "host/trace/flatten/flatten_hierarchy.h"

#include <algorithm>

#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

// A leaf's count has five bits on the traversal stack.
constexpr accel::BvhOptions kBvhOptions{.maxLeafSize = 8, .maxDepth = 60, .traversalCost = 1.2f, .intersectionCost = 1};
// A child of an 8-wide node is cheap compared with a primitive.
constexpr accel::BvhOptions kWideOptions{
    .maxLeafSize = accel::kMaxWideLeaf, .maxDepth = 60, .traversalCost = 0.4f, .intersectionCost = 1};
// Two primitives per leaf are part of the midpoint split's rule.
constexpr accel::BvhOptions kMidpointOptions{
    .rule = accel::SplitRule::midpoint, .maxLeafSize = 2, .maxDepth = kBvhOptions.maxDepth};

accel::BvhOptions withQuality(accel::BvhOptions options, render::BuildQuality quality) {
  if (quality == render::BuildQuality::fast) options.rule = accel::SplitRule::coarseSah;
  if (quality == render::BuildQuality::standard) options.reinsertion = accel::Reinsertion::trunk;
  if (quality == render::BuildQuality::high) options.reinsertion = accel::Reinsertion::all;
  return options;
}

accel::BvhOptions optionsFor(render::BvhSplit split, render::BuildQuality quality, render::BvhLayout layout) {
  if (split == render::BvhSplit::midpoint) return kMidpointOptions;
  return withQuality(layout == render::BvhLayout::cwbvh ? kWideOptions : kBvhOptions, quality);
}

// Appends a child in the format that its parent stores: its box and its reference.
void appendChild(const accel::BvhNode& child, std::span<const std::uint32_t> innerIndex, std::size_t index,
                 Rows& rows) {
  rows.push_back(row(glm::dvec3(child.bounds.min), child.isLeaf() ? child.first : innerIndex[index]));
  rows.push_back(row(glm::dvec3(child.bounds.max), child.count));
}

// Returns the records of interior nodes, in the order of the BVH; leaves are stored in their parents.
Rows nodeRows(const accel::Bvh& bvh) {
  std::vector<std::uint32_t> innerIndex(bvh.nodes.size());
  std::uint32_t innerCount = 0;
  for (std::size_t i = 0; i < bvh.nodes.size(); ++i) innerIndex[i] = bvh.nodes[i].isLeaf() ? 0 : innerCount++;
  Rows rows;
  rows.reserve(std::size_t{innerCount} * gpu::kNodeRows);
  for (const accel::BvhNode& node : bvh.nodes) {
    if (node.isLeaf()) continue;
    appendChild(bvh.nodes[node.first], innerIndex, node.first, rows);
    appendChild(bvh.nodes[node.first + 1], innerIndex, node.first + 1, rows);
  }
  return rows;
}

void noteQuality(const accel::BvhQuality& measured, FlatScene& flat) {
  flat.structureQuality = {{"sahCost", measured.sahCost},
                           {"depth", measured.depth},
                           {"nodes", measured.nodeCount},
                           {"leaves", measured.leafCount},
                           {"averageLeafSize", measured.averageLeafSize},
                           {"maxLeafSize", measured.maxLeafSize}};
}

// Appends binary nodes and returns the primitives, by index among the finite ones, in the order of the leaves.
std::vector<std::uint32_t> appendTwoWide(const accel::Bvh& bvh, const accel::BvhQuality& measured, FlatScene& flat) {
  if (bvh.nodes.size() > 1) flat.shape.structure = gpu::kStructureBvh;
  flat.shape.stackSize = std::max(1u, measured.depth);
  const Rows nodes = nodeRows(bvh);
  flat.rows.insert(flat.rows.end(), nodes.begin(), nodes.end());
  return bvh.primitiveIndices;
}

std::vector<std::uint32_t> appendWide(const accel::Bvh& bvh, FlatScene& flat) {
  accel::WideBvh wide = collapse(bvh);
  flat.shape.structure = gpu::kStructureWideBvh;
  flat.shape.stackSize = std::max(1u, stackWordsOf(wide));
  flat.structureQuality["depth"] = wide.depth;
  flat.structureQuality["nodes"] = wide.nodeCount;
  appendWideNodes(wide, flat.rows);
  return std::move(wide.primitiveIndices);
}

}  // namespace

render::BvhLayout layoutFor(const render::RenderSettings& settings) {
  if (settings.structure.bvhLayout != render::BvhLayout::automatic) return settings.structure.bvhLayout;
  return settings.structure.bvhSplit == render::BvhSplit::midpoint ? render::BvhLayout::bvh2
                                                                   : settings.execution.automatic.bvhLayout;
}

accel::Bvh buildHierarchy(std::span<const accel::Aabb> bounds, render::BvhSplit split, render::BuildQuality quality,
                          render::BvhLayout layout) {
  return buildBvh(bounds, optionsFor(split, quality, layout));
}

std::vector<std::uint32_t> appendHierarchy(const accel::SceneBounds& bounds, const render::RenderSettings& settings,
                                           FlatScene& flat) {
  const render::BvhLayout layout = layoutFor(settings);
  const accel::Bvh bvh = buildHierarchy(bounds.bounds, settings.structure.bvhSplit, settings.structure.bvhQuality,
                                        layout);
  const accel::BvhQuality measured = quality(bvh, kBvhOptions);
  noteQuality(measured, flat);
  flat.constants.firstStructureRow = rowCount(flat.rows);
  const bool wide = bvh.nodes.size() > 1 && layout == render::BvhLayout::cwbvh;
  std::vector<std::uint32_t> order = wide ? appendWide(bvh, flat) : appendTwoWide(bvh, measured, flat);
  for (std::uint32_t& i : order) i = bounds.finite[i];
  return order;
}

}  // namespace candela::flatten
