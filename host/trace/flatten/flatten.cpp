// Converts a scene to a FlatScene, one section of records after the other.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "host/base/errors.h"
#include "host/base/stopwatch.h"
#include "host/scene/coincidence/coincidence.h"
#include "host/scene/stored_primitives.h"
#include "host/trace/accel/primitive_bounds.h"
#include "host/trace/flatten/camera_constants.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/flatten/flatten_hierarchy.h"
#include "host/trace/flatten/flatten_instances.h"
#include "host/trace/flatten/flatten_primitives.h"
#include "host/trace/flatten/flatten_sections.h"
#include "host/trace/flatten/light_table.h"
#include "host/trace/flatten/touched_primitives.h"

namespace candela::flatten {
namespace {

constexpr std::uint32_t kMaxSlots = 1u << 27;  // limit of a packed stack word

void checkSlotCount(const scene::Scene& scene, const InstancePlan& plan) {
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  std::size_t count = plan.triangleCount;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (!plan.hasInstances() || !plan.isInstance[run]) count += scene.primitives.countOf(runs[run]);
  }
  if (count < kMaxSlots) return;
  throw FileError(fmt::format("{}: {} primitives; at most {} are supported", scene.name, count, kMaxSlots - 1));
}

void checkLimits(const scene::Scene& scene) {
  if (scene.materials.size() > gpu::kMaxMaterialCount) {
    throw FileError(fmt::format("{}: {} materials; at most {} are supported", scene.name, scene.materials.size(),
                                gpu::kMaxMaterialCount));
  }
}

// Returns the number of records of a tree's state. Only glass makes rays pending.
std::uint32_t treeRows(const SceneFeatures& features, std::uint32_t maxDepth) {
  return gpu::kTreeRows + (features.dielectric ? gpu::kPendingRows * (maxDepth - 1) : 0);
}

void setConstants(const scene::Scene& scene, const render::RenderSettings& settings, gpu::RenderConstants& constants) {
  setCamera(constants, *scene.camera, settings.image);
  constants.background = scene.background;
  constants.imageWidth = settings.image.window().width;
  constants.imageHeight = settings.image.window().height;
  setSampling(constants, settings.image);
  constants.maxDepth = settings.image.maxDepth;
  constants.rouletteStart = settings.image.rouletteStart;
  constants.indirectLimit = settings.image.indirectLimit.value_or(0);
}

// Returns whether the settings request a structure explicitly.
bool wantsStructure(const render::RenderSettings& settings) {
  if (settings.structure.accel == render::AccelKind::grid) return true;
  return settings.structure.accel == render::AccelKind::bvh &&
         (settings.structure.bvhSplit == render::BvhSplit::midpoint ||
          settings.structure.bvhLayout != render::BvhLayout::automatic);
}

// Builds the requested structure as the first records, and returns the order of the finite primitives.
std::vector<std::uint32_t> appendStructure(const accel::SceneBounds& bounds, const render::RenderSettings& settings,
                                           std::uint32_t maxGridSide, FlatScene& flat) {
  if (settings.structure.accel == render::AccelKind::bvh) return appendHierarchy(bounds, settings, flat);
  if (settings.structure.accel == render::AccelKind::none) return bounds.finite;
  return appendGrid(bounds, settings.structure.gridDensity, maxGridSide, flat);
}

// Returns the result of `build`, which appends a part of the structure, and adds its time and its records.
template <class Build>
auto measured(FlatScene& flat, const Build& build) {
  Stopwatch watch;
  const std::size_t rowsBefore = flat.rows.size();
  auto result = build();
  flat.structureSeconds += watch.lap();
  flat.structureQuality["bytes"] += static_cast<double>((flat.rows.size() - rowsBefore) * sizeof(gpu::uvec4));
  return result;
}

}  // namespace

render::LayoutInUse SceneShape::layout() const {
  if (uniformSlots > 0) return render::LayoutInUse::list;
  if (structure == gpu::kStructureBvh) return render::LayoutInUse::bvh2;
  return structure == gpu::kStructureWideBvh ? render::LayoutInUse::cwbvh : render::LayoutInUse::none;
}

FlatScene flattenScene(const scene::Scene& scene, const render::RenderSettings& settings, const FlattenLimits& limits) {
  checkLimits(scene);
  FlatScene flat;
  setConstants(scene, settings, flat.constants);
  flat.shape.features = featuresOf(scene, settings.image.integrator);
  noteCamera(*scene.camera, flat.constants, flat.shape);
  const bool whitted = settings.image.integrator == render::Integrator::whitted;
  const scene::Coincidences coincidences = scene::findCoincidences(scene);
  const InstancePlan plan = planInstances(scene, coincidences, settings);
  checkSlotCount(scene, plan);
  const accel::SceneBounds bounds = accel::boundPrimitives(scene, coincidences.coincident, plan.isInstance,
                                                           plan.coincidentReach);
  const bool small = isSmall(scene, coincidences.coincident, limits.smallScene);
  std::vector<std::uint32_t> order = bounds.finite;
  if (!small || wantsStructure(settings)) {
    order = measured(flat, [&] { return appendStructure(bounds, settings, limits.maxGridSide, flat); });
  }
  const bool isList = small && flat.shape.structure == gpu::kStructureNone;
  flat.constants.firstPlaneSlot = static_cast<std::uint32_t>(order.size());
  order.insert(order.end(), bounds.infinite.begin(), bounds.infinite.end());
  if (isList) {
    const scene::StoredPrimitives stored(scene.primitives);
    const auto marked = std::stable_partition(
        order.begin(), order.end(), [&](std::uint32_t i) { return !coincidences.coincident[stored.indexOf(i)]; });
    flat.shape.firstMarkedSlot = static_cast<std::uint32_t>(marked - order.begin());
  }
  flat.shape.slotCount = static_cast<std::uint32_t>(order.size());
  flat.constants.slotCount = flat.shape.slotCount;
  flat.shape.features.instances = plan.hasInstances();
  InstanceSlots instances;
  if (plan.hasInstances()) {
    instances = measured(flat,
                         [&] { return appendInstanceHierarchies(scene, plan, settings, flat.shape.slotCount, flat); });
  }

  LightTable lights;
  if (!whitted) lights = buildLightTable(scene, settings.image.nextEventEstimation, settings.image.lights);
  std::optional<LightTree> tree;
  if (lights.hasTree()) tree = buildLightTree(scene, lights, settings.image.oneSided);
  flat.shape.features.lightTree = lights.hasTree();
  flat.shape.features.lightInstances = !lights.meshes.empty();
  const std::span<const LightEntry> table = lights.entries;
  const PrimitiveMarks marks{touchedPrimitives(scene, lightPositions(scene, table, settings.image)),
                             coincidences.coincident, coincidences.ordered};
  noteLights(table, marks.touched, flat.shape.features);
  flat.shape.orderReach = coincidences.orderReach;
  flat.shape.coincident = coincidentKinds(scene, marks.coincident, settings.image.integrator);
  appendPrimitives(scene, {order, std::move(instances.orders), plan.isInstance}, table, marks, settings.image, flat);
  if (plan.hasInstances()) appendInstances(scene, plan, instances, bounds.coincidentReach, flat);
  flat.shape.rowsAhead = limits.smallScene.rowsAhead;
  if (isList) copySlotRows(flat);
  const SurfaceOrder surfaces = orderSurfaces(scene);
  appendMaterials(scene, settings.image.integrator, surfaces, flat);
  appendSurfaces(scene, surfaces, flat);
  if (whitted) {
    appendPointLights(scene, settings.image.lightSize, flat);
    flat.constants.stateRows = treeRows(flat.shape.features, settings.image.maxDepth);
  } else {
    appendLights(scene, lights, order, flat);
    if (tree) appendLightTree(*tree, lights.treeThreshold, flat);
  }
  flat.constants.firstTextureRow = rowCount(flat.rows);
  if (flat.shape.features.textures) {
    flat.shape.textureSlots = textureSlotsOf(scene);
    const Rows textures = textureRows(scene);
    flat.rows.insert(flat.rows.end(), textures.begin(), textures.end());
  }
  flat.constants.firstSkyRow = rowCount(flat.rows);
  if (scene.sky) {
    const Rows sky = skyRows(*scene.sky);
    flat.rows.insert(flat.rows.end(), sky.begin(), sky.end());
  }
  if (scene.environment) appendEnvironment(*scene.environment, flat);
  return flat;
}

}  // namespace candela::flatten
