// Converts a scene to a FlatScene, one section of records after the other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "host/accel/primitive_bounds.h"
#include "host/core/errors.h"
#include "host/core/stopwatch.h"
#include "host/flatten/camera_constants.h"
#include "host/flatten/flat_rows.h"
#include "host/flatten/flat_scene.h"
#include "host/flatten/flatten_hierarchy.h"
#include "host/flatten/flatten_primitives.h"
#include "host/flatten/flatten_sections.h"
#include "host/flatten/light_table.h"
#include "host/flatten/lobes.h"
#include "host/flatten/touched_primitives.h"

namespace candela::flatten {
namespace {

static_assert(static_cast<std::uint32_t>(LightKind::sphere) == gpu::kLightSphere);
static_assert(static_cast<std::uint32_t>(LightKind::triangle) == gpu::kLightTriangle);
static_assert(static_cast<std::uint32_t>(LightKind::point) == gpu::kLightPoint);
static_assert(static_cast<std::uint32_t>(LightKind::punctual) == gpu::kLightPunctual);
static_assert(static_cast<std::uint32_t>(LightKind::spot) == gpu::kLightSpot);
static_assert(static_cast<std::uint32_t>(LightKind::directional) == gpu::kLightDirectional);
static_assert(static_cast<std::uint32_t>(LightKind::environment) == gpu::kLightEnvironment);

constexpr std::uint32_t kMaxSlots = 1u << 27;  // limit of a packed stack word

void checkLimits(const scene::Scene& scene) {
  if (scene.primitives.size() >= kMaxSlots) {
    throw FileError(
        fmt::format("{}: {} primitives; at most {} are supported", scene.name, scene.primitives.size(), kMaxSlots - 1));
  }
  if (scene.materials.size() > gpu::kMaxMaterialCount) {
    throw FileError(fmt::format("{}: {} materials; at most {} are supported", scene.name, scene.materials.size(),
                                gpu::kMaxMaterialCount));
  }
}

void appendMaterials(const scene::Scene& scene, render::Integrator integrator, const SurfaceOrder& order,
                     FlatScene& flat) {
  flat.constants.firstMaterialRow = rowCount(flat.rows);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const scene::Material& material = scene.materials[i];
    const Lobes lobes = lobesFor(integrator, material);
    flat.rows.push_back(row(lobes.diffuseColour, lobes.diffuse));
    flat.rows.push_back(row(lobes.glossyColour, lobes.glossy));
    flat.rows.push_back(row(ownRadiance(integrator, material), lobes.dielectric));
    flat.rows.push_back(
        {floatBits(lobes.exponent), floatBits(lobes.ior), floatBits(lobes.mirror ? 1 : 0), order.numbers[i]});
    flat.rows.push_back(row(lobes.specularColour, 0.0));
  }
}

void appendSurfaces(const scene::Scene& scene, const SurfaceOrder& order, FlatScene& flat) {
  const Rows surfaces = surfaceRows(scene, order);
  flat.constants.firstSurfaceRow = rowCount(flat.rows);
  flat.rows.insert(flat.rows.end(), surfaces.begin(), surfaces.end());
  flat.constants.firstEnergyRow = rowCount(flat.rows);
  if (surfaces.empty()) return;
  const Rows energy = energyRows(flat.features);
  flat.rows.insert(flat.rows.end(), energy.begin(), energy.end());
}

// Returns the slot of every primitive, for the lights.
std::vector<std::uint32_t> slotsOf(std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> slots(order.size());
  for (std::uint32_t slot = 0; slot < order.size(); ++slot) slots[order[slot]] = slot;
  return slots;
}

void appendPointLight(const scene::PointLight& light, const LightEntry& entry, Rows& rows) {
  rows.push_back({entry.threshold, floatBits(entry.probability), gpu::kLightPoint, gpu::kNoSlot});
  rows.push_back(row(glm::dvec3(light.colour), 0.0));
  rows.push_back(row(glm::dvec3(light.position), 0.0));
}

// `cone`: the index of a spot light's cone among all cones, which follow the last light.
void appendPunctualLight(const scene::PunctualLight& light, const LightEntry& entry, std::size_t cone, Rows& rows) {
  const bool isSpot = entry.kind == LightKind::spot;
  const glm::dvec3 point = entry.kind == LightKind::directional ? -glm::dvec3(light.direction)
                                                                : glm::dvec3(light.position);
  rows.push_back({entry.threshold, floatBits(entry.probability), static_cast<std::uint32_t>(entry.kind), gpu::kNoSlot});
  rows.push_back(row(glm::dvec3(light.intensity), isSpot ? static_cast<double>(cone) : 0.0));
  rows.push_back(row(point, isSpot ? 1 / (double{light.versineOuter} - double{light.versineInner}) : 0.0));
}

void appendEnvironmentEntry(const LightEntry& entry, Rows& rows) {
  rows.push_back({entry.threshold, floatBits(entry.probability), gpu::kLightEnvironment, gpu::kNoSlot});
  rows.insert(rows.end(), gpu::kLightRows - 1, gpu::uvec4(0));
}

void appendEmitter(const scene::Scene& scene, const LightEntry& entry, std::uint32_t slot, Rows& rows) {
  const scene::Primitive& primitive = scene.primitives[entry.index];
  const glm::dvec3 emission(scene.materials[primitive.material].emission);
  const bool sphere = entry.kind == LightKind::sphere;
  rows.push_back({entry.threshold, floatBits(entry.probability), static_cast<std::uint32_t>(entry.kind), slot});
  rows.push_back(row(emission, sphere ? 0.0 : triangleArea(triangleOf(scene, primitive))));
  const scene::Sphere ball = sphere ? scene.spheres[primitive.index] : scene::Sphere{glm::vec3(0), 0};
  rows.push_back(row(glm::dvec3(ball.centre), std::abs(double{ball.radius})));
}

void appendLights(const scene::Scene& scene, std::span<const LightEntry> table, std::span<const std::uint32_t> slots,
                  FlatScene& flat) {
  flat.constants.firstLightRow = rowCount(flat.rows);
  flat.constants.lightCount = static_cast<std::uint32_t>(table.size());
  Rows cones;
  for (const LightEntry& entry : table) {
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
    } else {
      appendEmitter(scene, entry, slots[entry.index], flat.rows);
    }
  }
  flat.rows.insert(flat.rows.end(), cones.begin(), cones.end());
}

void appendEnvironment(const scene::Environment& environment, FlatScene& flat) {
  flat.constants.environmentX = environment.axes[0];
  flat.constants.environmentY = environment.axes[1];
  flat.constants.environmentZ = environment.axes[2];
  flat.constants.environmentWidth = environment.width;
  flat.constants.environmentHeight = environment.height;
  flat.constants.firstEnvironmentRow = rowCount(flat.rows);
  const Rows rows = environmentRows(environment);
  flat.rows.insert(flat.rows.end(), rows.begin(), rows.end());
}

void appendPointLights(const scene::Scene& scene, double lightSize, FlatScene& flat) {
  const Rows lights = pointLightRows(scene.pointLights, *scene.camera, lightSize);
  flat.constants.firstLightRow = rowCount(flat.rows);
  flat.constants.lightCount = static_cast<std::uint32_t>(scene.pointLights.size());
  flat.rows.insert(flat.rows.end(), lights.begin(), lights.end());
}

// Returns the number of records of a tree's state. Only glass makes rays pending.
std::uint32_t treeRows(const SceneFeatures& features, std::uint32_t maxDepth) {
  return gpu::kTreeRows + (features.dielectric ? gpu::kPendingRows * (maxDepth - 1) : 0);
}

// Estimates the number of records of a triangle's attributes: three for each attribute that the scene has.
std::size_t attributeRowsOf(const SceneFeatures& features) {
  constexpr std::size_t kVectorRows = 3;  // of colours and of tangents
  const std::size_t coordinates = features.textures ? gpu::kTexCoordRows : 0;
  const std::size_t vectors = kVectorRows * (std::size_t{features.colours} + std::size_t{features.tangents});
  return features.smooth || coordinates + vectors > 0 ? gpu::kNormalRows + coordinates + vectors : 0;
}

void appendPrimitives(const scene::Scene& scene, std::span<const std::uint32_t> order,
                      std::span<const LightEntry> table, const std::vector<bool>& touched, bool keepsTexCoords,
                      FlatScene& flat) {
  std::vector<std::uint32_t> lightOf(scene.primitives.size(), 0);
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    if (table[i].isEmitter()) lightOf[table[i].index] = i + 1;
  }
  // Vectors that grow would copy the records of large meshes several times. Memory beyond the part in use is never
  // touched.
  const std::size_t attributeRows = order.size() * attributeRowsOf(flat.features);
  Rows attributes;
  attributes.reserve(attributeRows);
  flat.rows.reserve(flat.rows.size() + order.size() * gpu::kPrimitiveRows + attributeRows);
  flat.constants.firstPrimitiveRow = rowCount(flat.rows);
  for (const std::uint32_t primitive : order) {
    const PrimitiveContext context{.primitive = primitive,
                                   .light = lightOf[primitive],
                                   .touched = touched[primitive],
                                   .keepsTexCoords = keepsTexCoords};
    appendPrimitive(scene, context, flat.rows, attributes);
  }
  flat.constants.firstAttributeRow = rowCount(flat.rows);
  flat.rows.insert(flat.rows.end(), attributes.begin(), attributes.end());
}

// Copies the records of slots to the uniform buffer.
void copySlotRows(FlatScene& flat) {
  flat.uniformSlots = flat.slotCount;
  const auto first = flat.rows.begin() + flat.constants.firstPrimitiveRow;
  std::copy_n(first, flat.uniformSlots * gpu::kPrimitiveRows, flat.slotRows.begin());
  for (std::uint32_t slot = 0; slot < flat.uniformSlots; ++slot) {
    const std::uint32_t kindAndFlags = first[slot * gpu::kPrimitiveRows + 2].w & 0xffu;
    flat.uniformKinds[slot / 4] |= kindAndFlags << 8 * (slot % 4);
  }
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
  Stopwatch watch;
  std::vector<std::uint32_t> order = bounds.finite;
  if (settings.structure.accel == render::AccelKind::bvh) order = appendHierarchy(bounds, settings, flat);
  if (settings.structure.accel == render::AccelKind::grid)
    order = appendGrid(bounds, settings.structure.gridDensity, maxGridSide, flat);
  flat.structureSeconds = watch.lap();
  flat.structureQuality["bytes"] = static_cast<double>(flat.rows.size() * sizeof(gpu::uvec4));
  return order;
}

}  // namespace

render::LayoutInUse FlatScene::layout() const {
  if (uniformSlots > 0) return render::LayoutInUse::list;
  if (structure == gpu::kStructureBvh) return render::LayoutInUse::bvh2;
  return structure == gpu::kStructureWideBvh ? render::LayoutInUse::cwbvh : render::LayoutInUse::none;
}

FlatScene flattenScene(const scene::Scene& scene, const render::RenderSettings& settings, const FlattenLimits& limits) {
  checkLimits(scene);
  FlatScene flat;
  setConstants(scene, settings, flat.constants);
  flat.features = featuresOf(scene, settings.image.integrator);
  const bool whitted = settings.image.integrator == render::Integrator::whitted;
  const accel::SceneBounds bounds = accel::boundPrimitives(scene);
  const bool small = isSmall(scene, limits.smallScene);
  std::vector<std::uint32_t> order = bounds.finite;
  if (!small || wantsStructure(settings)) order = appendStructure(bounds, settings, limits.maxGridSide, flat);
  flat.constants.firstPlaneSlot = static_cast<std::uint32_t>(order.size());
  order.insert(order.end(), bounds.infinite.begin(), bounds.infinite.end());
  flat.slotCount = static_cast<std::uint32_t>(order.size());
  flat.constants.slotCount = flat.slotCount;

  const std::vector<LightEntry> table = whitted ? std::vector<LightEntry>{}
                                                : buildLightTable(scene, settings.image.nextEventEstimation);
  const std::vector<bool> touched = touchedPrimitives(scene, lightPositions(scene, table, settings.image));
  noteLights(table, touched, flat.features);
  appendPrimitives(scene, order, table, touched, settings.image.layers.has(image::Layer::uv), flat);
  flat.rowsAhead = limits.smallScene.rowsAhead;
  if (small && flat.structure == gpu::kStructureNone) copySlotRows(flat);
  const SurfaceOrder surfaces = orderSurfaces(scene);
  appendMaterials(scene, settings.image.integrator, surfaces, flat);
  appendSurfaces(scene, surfaces, flat);
  if (whitted) {
    appendPointLights(scene, settings.image.lightSize, flat);
    flat.constants.stateRows = treeRows(flat.features, settings.image.maxDepth);
  } else {
    appendLights(scene, table, slotsOf(order), flat);
  }
  flat.constants.firstTextureRow = rowCount(flat.rows);
  if (flat.features.textures) {
    flat.textureSlots = textureSlotsOf(scene);
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
