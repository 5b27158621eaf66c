// Stores the trees of meshes that emit, and for each instance its placement and where its triangles are.
#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>
#include <vector>

#include "host/scene/placement.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

constexpr double kNormalSlack = 0x1p-11;

// Appends words, four in a record, and returns the index of the first one.
std::uint32_t appendWords(std::span<const std::uint32_t> words, Rows& rows) {
  const std::uint32_t first = 4 * rowCount(rows);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i % 4 == 0) rows.push_back({});
    rows.back()[static_cast<glm::length_t>(i % 4)] = words[i];
  }
  return first;
}

// Returns the first record of the tree of a mesh.
std::uint32_t appendMeshTree(const LightMesh& mesh, Rows& rows) {
  const std::uint32_t trails = appendWords(mesh.trails, rows);
  const std::uint32_t header = rowCount(rows);
  rows.push_back({0, trails, static_cast<std::uint32_t>(mesh.tree.leaves.size()), 0});
  appendLightNodes(mesh.tree, rows);
  return header;
}

double squaredNorm(const glm::dmat3& m) { return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]); }

void appendPlacement(const scene::Placement& placement, std::uint32_t tree, std::uint32_t slots, Rows& rows) {
  const glm::dmat3 linear = linearPartOf(placement);
  const glm::dmat3 inverse(inverseOf(placement));
  const glm::dmat3 rowsOfInverse = glm::transpose(inverse);
  const auto condition = static_cast<float>(std::sqrt(squaredNorm(linear)) * std::sqrt(squaredNorm(inverse)));
  const glm::dvec3 translation = translationOf(placement);
  for (glm::length_t column = 0; column < 3; ++column) rows.push_back(row(linear[column], translation[column]));
  rows.push_back(row(rowsOfInverse[0], kNormalSlack * double{condition}));
  rows.push_back(row(rowsOfInverse[1], tree));
  rows.push_back(row(rowsOfInverse[2], slots));
}

// Returns the slots of the triangles of instances that emit, by entry of the light table.
std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> slotsOfInstances(const LightTable& table,
                                                                               std::span<const std::uint32_t> order) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> slots;
  std::vector<std::uint32_t> firsts, entries;
  for (std::uint32_t i = 0; i < table.entries.size(); ++i) {
    const LightEntry& entry = table.entries[i];
    if (!entry.isInstance()) continue;
    slots[i].assign(table.meshes[entry.mesh].luminances.size(), gpu::kNoSlot);
    firsts.push_back(entry.index);
    entries.push_back(i);
  }
  for (std::uint32_t slot = 0; slot < order.size() && !firsts.empty(); ++slot) {
    const auto after = std::ranges::upper_bound(firsts, order[slot]);
    if (after == firsts.begin()) continue;
    const auto found = static_cast<std::size_t>(after - firsts.begin() - 1);
    std::vector<std::uint32_t>& triangles = slots[entries[found]];
    const std::uint32_t triangle = order[slot] - firsts[found];
    if (triangle < triangles.size()) triangles[triangle] = slot;
  }
  return slots;
}

}  // namespace

std::unordered_map<std::uint32_t, std::uint32_t> appendLightInstances(const scene::Scene& scene,
                                                                      const LightTable& table,
                                                                      std::span<const std::uint32_t> order,
                                                                      FlatScene& flat) {
  std::vector<std::uint32_t> trees;
  for (const LightMesh& mesh : table.meshes) trees.push_back(appendMeshTree(mesh, flat.rows));
  std::unordered_map<std::uint32_t, std::uint32_t> records;
  for (const auto& [entry, slots] : slotsOfInstances(table, order)) {
    const std::uint32_t firstSlot = appendWords(slots, flat.rows);
    records[entry] = rowCount(flat.rows);
    const scene::Primitive start = scene.primitives[table.entries[entry].index];
    appendPlacement(scene.placements[start.placement], trees[table.entries[entry].mesh], firstSlot, flat.rows);
  }
  return records;
}

}  // namespace candela::flatten
