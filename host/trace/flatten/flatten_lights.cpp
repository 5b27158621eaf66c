// Stores the light table of the path tracer as 16-byte records.
#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>
#include <vector>

#include "host/scene/shape.h"
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

// The probability of an entry; of a light that a tree chooses, its trail.
std::uint32_t probabilityWord(const LightEntry& entry) {
  return entry.trail ? *entry.trail : floatBits(entry.probability);
}

void appendPointLight(const scene::PointLight& light, const LightEntry& entry, Rows& rows) {
  rows.push_back({entry.threshold, probabilityWord(entry), 0, gpu::kNoSlot});
  rows.push_back(row(glm::dvec3(light.colour), gpu::kLightPoint));
  rows.push_back(row(glm::dvec3(light.position), 0.0));
}

// `cone`: the index of a spot light's cone among all cones, which follow the last light.
void appendPunctualLight(const scene::PunctualLight& light, const LightEntry& entry, std::size_t cone, Rows& rows) {
  const bool isSpot = entry.kind == LightKind::spot;
  const glm::dvec3 point = entry.kind == LightKind::directional ? -glm::dvec3(light.direction)
                                                                : glm::dvec3(light.position);
  const std::uint32_t coneWord = isSpot ? floatBits(static_cast<double>(cone)) : 0;
  rows.push_back({entry.threshold, probabilityWord(entry), coneWord, gpu::kNoSlot});
  rows.push_back(row(glm::dvec3(light.intensity), static_cast<std::uint32_t>(entry.kind)));
  rows.push_back(row(point, isSpot ? 1 / (double{light.versineOuter} - double{light.versineInner}) : 0.0));
}

void appendEnvironmentEntry(const LightEntry& entry, Rows& rows) {
  rows.push_back({entry.threshold, probabilityWord(entry), 0, gpu::kNoSlot});
  rows.push_back({0, 0, 0, gpu::kLightEnvironment});
  rows.push_back({});
}

void appendEmitter(const scene::Scene& scene, const LightEntry& entry, std::uint32_t slot, Rows& rows) {
  const scene::Primitive& primitive = scene.primitives[entry.index];
  const glm::dvec3 emission(scene.materials[primitive.material].emission);
  const bool sphere = entry.kind == LightKind::sphere;
  const double area = sphere ? 0.0 : triangleArea(triangleOf(scene, primitive));
  rows.push_back({entry.threshold, probabilityWord(entry), floatBits(area), slot});
  rows.push_back(row(emission, static_cast<std::uint32_t>(entry.kind)));
  const scene::Sphere ball = sphere ? scene.spheres[primitive.index] : scene::Sphere{glm::vec3(0), 0};
  rows.push_back(row(glm::dvec3(ball.centre), std::abs(double{ball.radius})));
}

// `record`: the first one of the instance.
void appendInstance(const scene::Scene& scene, const LightEntry& entry, std::uint32_t record, Rows& rows) {
  const glm::dvec3 emission(scene.materials[scene.primitives[entry.index].material].emission);
  rows.push_back({entry.threshold, probabilityWord(entry), record, gpu::kNoSlot});
  rows.push_back(row(emission, gpu::kLightTriangle));
  rows.push_back({});
}

// Returns the slots of the emitters of a table, which are its first entries, in the order of their primitives.
std::vector<std::uint32_t> slotsOf(std::span<const LightEntry> table, std::span<const std::uint32_t> order) {
  const auto emitters = std::ranges::subrange(table.begin(),
                                              std::ranges::partition_point(table, &LightEntry::isEmitter));
  std::vector<std::uint32_t> slots(emitters.size(), gpu::kNoSlot);
  if (slots.empty()) return slots;
  for (std::uint32_t slot = 0; slot < order.size(); ++slot) {
    const auto found = std::ranges::lower_bound(emitters, order[slot], {}, &LightEntry::index);
    if (found != emitters.end() && found->index == order[slot])
      slots[static_cast<std::size_t>(found - emitters.begin())] = slot;
  }
  return slots;
}

gpu::uvec4 rowOf(const glm::vec3& xyz, float w) { return row(glm::dvec3(xyz), double{w}); }

void appendLightNode(const LightNode& node, Rows& rows) {
  rows.push_back(rowOf(node.centre, node.radius));
  rows.push_back({floatBits(node.power), node.axis, floatBits(node.cosine), node.next});
}

}  // namespace

void appendLightNodes(const LightTree& tree, Rows& rows) {
  for (const LightNode& node : tree.leaves) appendLightNode(node, rows);
  for (const LightNode& node : tree.inner) appendLightNode(node, rows);
}

void appendLightTree(const LightTree& tree, std::uint32_t threshold, FlatScene& flat) {
  flat.constants.firstLightTreeRow = rowCount(flat.rows);
  const auto leaves = static_cast<std::uint32_t>(tree.leaves.size());
  flat.rows.push_back({threshold, floatBits(threshold * 0x1p-24), leaves, 0});
  appendLightNodes(tree, flat.rows);
}

void appendLights(const scene::Scene& scene, const LightTable& table, std::span<const std::uint32_t> order,
                  FlatScene& flat) {
  const auto instances = appendLightInstances(scene, table, order, flat);
  flat.constants.firstLightRow = rowCount(flat.rows);
  flat.constants.lightCount = static_cast<std::uint32_t>(table.entries.size());
  const std::vector<std::uint32_t> slots = slotsOf(table.entries, order);
  Rows cones;
  for (std::uint32_t i = 0; i < table.entries.size(); ++i) {
    const LightEntry& entry = table.entries[i];
    if (entry.isPoint()) {
      appendPointLight(scene.pointLights[entry.index], entry, flat.rows);
    } else if (entry.isEnvironment()) {
      appendEnvironmentEntry(entry, flat.rows);
      flat.constants.environmentProbability = entry.probability;
    } else if (entry.isPunctual()) {
      const scene::PunctualLight& light = scene.punctualLights[entry.index];
      appendPunctualLight(light, entry, cones.size(), flat.rows);
      if (entry.kind == LightKind::spot) {
        cones.push_back(row(glm::dvec3(light.direction), double{light.versineOuter}));
      }
    } else if (entry.isInstance()) {
      appendInstance(scene, entry, instances.at(i), flat.rows);
    } else {
      appendEmitter(scene, entry, slots[i], flat.rows);
    }
  }
  flat.rows.insert(flat.rows.end(), cones.begin(), cones.end());
}

}  // namespace candela::flatten
