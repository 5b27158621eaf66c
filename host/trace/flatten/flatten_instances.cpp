// Chooses instances, builds their BVHs, and stores them as 16-byte records.
#include "host/trace/flatten/flatten_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "host/base/errors.h"
#include "host/scene/stored_primitives.h"
#include "host/trace/accel/instance_space.h"
#include "host/trace/flatten/flat_rows.h"
#include "host/trace/flatten/flatten_hierarchy.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

constexpr std::size_t kMinUses = 2;
// Number of parts of a mesh whose boxes are placed to bound an instance.
constexpr std::size_t kBoundedParts = 64;
// An instance is tested when its leaf is reached, which costs much more than a node.
constexpr accel::BvhOptions kOuterOptions{.reinsertion = accel::Reinsertion::all,
                                          .maxLeafSize = 1,
                                          .maxDepth = 60,
                                          .traversalCost = 1,
                                          .intersectionCost = 8};

using PrototypeKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

std::span<const scene::PrimitiveRun> runsOf(const scene::Scene& scene) { return scene.primitives.runs(); }

// Returns the box of the vertices of a mesh's triangle.
accel::Aabb boxOfTriangle(const scene::Mesh& mesh, std::uint32_t triangle) {
  accel::Aabb box;
  for (const glm::vec3& point : attributeOf(mesh, mesh.positions, triangle)) box.extend(point);
  return box;
}

accel::Aabb meshBounds(const scene::Scene& scene, const Prototype& prototype) {
  const scene::Primitive& start = runsOf(scene)[prototype.uses.front()].start;
  accel::Aabb box;
  for (std::uint32_t i = 0; i < prototype.triangleCount; ++i) {
    box.extend(boxOfTriangle(meshOf(scene, start), start.index + i));
  }
  return box;
}

// Returns the largest coordinate of the instances of a prototype.
float reachOf(const scene::Scene& scene, const Prototype& prototype) {
  float reach = 0;
  for (const std::uint32_t use : prototype.uses) {
    const scene::Placement& placement = scene.placements[runsOf(scene)[use].start.placement];
    reach = std::max(reach, largestCoordinate(accel::placedBounds(placement, prototype.bounds)));
  }
  return reach;
}

// The triangles of a prototype in the space of their mesh.
struct MeshSpace {
  accel::Bvh bvh;
  std::vector<accel::Aabb> parts;  ///< boxes that together contain all triangles
};

// Returns the boxes of nodes of the upper levels of a BVH, which together contain all of its primitives.
std::vector<accel::Aabb> partsOf(const accel::Bvh& bvh) {
  std::vector<std::uint32_t> nodes{0};
  for (std::size_t next = 0; next < nodes.size() && nodes.size() < kBoundedParts; ++next) {
    const accel::BvhNode& node = bvh.nodes[nodes[next]];
    if (node.isLeaf()) continue;
    nodes[next] = node.first;
    nodes.push_back(node.first + 1);
  }
  std::vector<accel::Aabb> parts;
  for (const std::uint32_t node : nodes) parts.push_back(bvh.nodes[node].bounds);
  return parts;
}

MeshSpace buildMeshSpace(const scene::Scene& scene, const scene::Primitive& start, std::uint32_t count,
                         const render::RenderSettings& settings) {
  const scene::Mesh& mesh = meshOf(scene, start);
  MeshSpace space;
  std::vector<accel::Aabb> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const accel::Aabb box = boxOfTriangle(mesh, start.index + i);
    boxes.push_back(accel::paddedBounds(glm::dvec3(box.min), glm::dvec3(box.max)));
  }
  space.bvh = buildHierarchy(boxes, settings.structure.bvhSplit, settings.structure.bvhQuality,
                             render::BvhLayout::cwbvh);
  space.parts = partsOf(space.bvh);
  return space;
}

// Appends the nodes of an 8-wide BVH whose primitives begin at a slot. Returns the node of its root.
std::uint32_t appendNodes(accel::WideBvh& wide, std::uint32_t firstSlot, FlatScene& flat) {
  const auto root = (rowCount(flat.rows) - flat.constants.firstStructureRow) / gpu::kWideNodeRows;
  if (root + wide.nodes.size() > accel::kMaxWideNodes) {
    throw FileError(fmt::format("the BVHs of the scene have more than {} nodes", accel::kMaxWideNodes));
  }
  for (accel::WideNode& node : wide.nodes) {
    node.block += root;
    node.firstPrimitive += firstSlot;
  }
  appendWideNodes(wide, flat.rows);
  return root;
}

bool mayHaveInstances(const render::RenderSettings& settings) {
  return settings.structure.accel == render::AccelKind::bvh && !settings.structure.copiesInstances &&
         layoutFor(settings) == render::BvhLayout::cwbvh;
}

accel::Aabb placedBounds(const scene::Placement& placement, const std::vector<accel::Aabb>& parts) {
  accel::Aabb box;
  for (const accel::Aabb& part : parts) box.extend(accel::placedBounds(placement, part));
  return box;
}

}  // namespace

InstancePlan planInstances(const scene::Scene& scene, const scene::Coincidences& coincidences,
                           const render::RenderSettings& settings) {
  InstancePlan plan;
  if (scene.placements.empty() || !mayHaveInstances(settings)) return plan;
  const scene::StoredPrimitives stored(scene.primitives);
  std::map<PrototypeKey, Prototype> candidates;
  for (std::uint32_t i = 0; i < runsOf(scene).size(); ++i) {
    const scene::PrimitiveRun& run = runsOf(scene)[i];
    if (!isInstance(scene, run)) continue;
    const std::uint32_t count = scene.primitives.countOf(run);
    Prototype& prototype = candidates[{run.start.mesh, run.start.index, count, run.start.material}];
    prototype.uses.push_back(i);
    prototype.triangleCount = count;
  }
  for (auto& [key, prototype] : candidates) {
    if (prototype.uses.size() < kMinUses) continue;
    plan.isInstance.resize(runsOf(scene).size());
    for (const std::uint32_t use : prototype.uses) plan.isInstance[use] = true;
    const std::uint32_t first = stored.firstOf(prototype.uses.front());
    for (std::uint32_t i = 0; i < prototype.triangleCount; ++i) {
      prototype.coincident = prototype.coincident || coincidences.coincident[first + i];
    }
    prototype.bounds = meshBounds(scene, prototype);
    if (prototype.coincident) plan.coincidentReach = std::max(plan.coincidentReach, reachOf(scene, prototype));
    plan.triangleCount += prototype.triangleCount;
    plan.prototypes.push_back(std::move(prototype));
  }
  return plan;
}

InstanceSlots appendInstanceHierarchies(const scene::Scene& scene, const InstancePlan& plan,
                                        const render::RenderSettings& settings, std::uint32_t slotCount,
                                        FlatScene& flat) {
  InstanceSlots slots;
  std::vector<accel::Aabb> boxes;
  std::vector<InstanceUse> uses;
  std::uint32_t innerWords = 0;
  for (std::uint32_t p = 0; p < plan.prototypes.size(); ++p) {
    const Prototype& prototype = plan.prototypes[p];
    const scene::PrimitiveRun& first = runsOf(scene)[prototype.uses.front()];
    const MeshSpace space = buildMeshSpace(scene, first.start, prototype.triangleCount, settings);
    accel::WideBvh wide = collapse(space.bvh);
    slots.roots.push_back(appendNodes(wide, slotCount, flat));
    slotCount += prototype.triangleCount;
    innerWords = std::max(innerWords, stackWordsOf(wide));
    for (std::uint32_t& i : wide.primitiveIndices) i += first.first;
    slots.orders.push_back(std::move(wide.primitiveIndices));
    for (const std::uint32_t use : prototype.uses) {
      boxes.push_back(placedBounds(scene.placements[runsOf(scene)[use].start.placement], space.parts));
      uses.push_back({use, p});
    }
  }
  accel::WideBvh outer = collapse(buildBvh(boxes, kOuterOptions));
  flat.constants.topNode = appendNodes(outer, 0, flat);
  for (const std::uint32_t i : outer.primitiveIndices) slots.uses.push_back(uses[i]);
  flat.shape.stackSize = std::max(flat.shape.stackSize, stackWordsOf(outer) + innerWords);
  flat.structureQuality["instances"] = static_cast<double>(uses.size());
  flat.structureQuality["instanceTriangles"] = plan.triangleCount;
  return slots;
}

void appendInstances(const scene::Scene& scene, const InstancePlan& plan, const InstanceSlots& slots,
                     float coincidentReach, FlatScene& flat) {
  flat.constants.firstInstanceRow = rowCount(flat.rows);
  for (const InstanceUse& use : slots.uses) {
    const scene::PrimitiveRun& run = runsOf(scene)[use.run];
    const scene::Placement& placement = scene.placements[run.start.placement];
    const Prototype& prototype = plan.prototypes[use.prototype];
    const accel::InstanceSpace space = accel::instanceSpace(placement, prototype.bounds,
                                                            prototype.coincident ? coincidentReach : 0);
    const std::array<std::uint32_t, 4> lanes{run.first, slots.roots[use.prototype], floatBits(double{space.padding}),
                                             floatBits(double{space.paddingPerOrigin})};
    const auto column = [](const scene::PlacementRows& rows, glm::length_t i) {
      return glm::dvec3(rows[0][i], rows[1][i], rows[2][i]);
    };
    for (glm::length_t i = 0; i < 4; ++i) {
      flat.rows.push_back(row(column(placement.points, i), lanes[static_cast<std::size_t>(i)]));
    }
    for (glm::length_t i = 0; i < 3; ++i) flat.rows.push_back(row(column(placement.normals, i), 0u));
    for (const glm::vec3& v : space.columns) flat.rows.push_back(row(glm::dvec3(v), 0u));
  }
}

}  // namespace candela::flatten
