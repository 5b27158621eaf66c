// Stores primitives as 16-byte records.
#include "host/trace/flatten/flatten_primitives.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"
#include "host/trace/flatten/geometries.h"

namespace candela::flatten {
namespace {

// Returns the point of the sphere nearest to the camera. Rays hit a huge sphere near that point, so its coordinates are
// small.
glm::dvec3 sphereAnchor(const glm::dvec3& eye, const glm::dvec3& centre, double radius) {
  const glm::dvec3 towardsCamera = eye - centre;
  const double distance = glm::length(towardsCamera);
  const glm::dvec3 direction = distance > 0 ? towardsCamera / distance : glm::dvec3(1, 0, 0);
  return glm::dvec3(glm::vec3(centre + radius * direction));
}

std::uint32_t kindWord(const scene::Scene& scene, const PrimitiveContext& context, std::uint32_t kindAndFlags) {
  const scene::Primitive& primitive = context.primitive;
  const std::uint32_t touched = context.touched ? gpu::kFlagTouched : 0;
  const std::uint32_t opaque = scene.materials[primitive.material].opaque ? gpu::kFlagOpaque : 0;
  const std::uint32_t ordered = context.ordered ? gpu::kFlagOrdered : 0;
  return kindAndFlags | touched | opaque | ordered | context.coincidence | primitive.material << gpu::kMaterialShift;
}

void appendShape(const scene::Sphere& sphere, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows) {
  const std::uint32_t inside = sphere.radius < 0 ? gpu::kFlagInsideOnly : 0;
  rows.push_back({});
  rows.push_back({0, 0, 0, context.index});
  placeSphere(sphere, scene.camera->from, std::span(rows).last<2>());
  rows.push_back({context.reference, 0, 0, kindWord(scene, context, gpu::kKindSphere | inside)});
}

void appendShape(const scene::Triangle& triangle, const scene::Scene& scene, const PrimitiveContext& context,
                 Rows& rows) {
  const std::uint32_t passed = scene.materials[context.primitive.material].opacity ? gpu::kFlagTransparent : 0;
  rows.push_back(row(glm::dvec3(triangle.p[0]), context.reference));
  rows.push_back(row(glm::dvec3(triangle.p[1]), context.index));
  rows.push_back(row(glm::dvec3(triangle.p[2]), kindWord(scene, context, gpu::kKindTriangle | passed)));
}

void appendShape(const scene::Box& box, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows) {
  rows.push_back(row(glm::dvec3(box.min), 0u));
  rows.push_back(row(glm::dvec3(box.max), context.index));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindBox)});
}

// Equal cones with their ends in either order have equal distances if their records are equal.
void appendShape(const scene::Cone& stated, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows) {
  const scene::Cone cone = context.coincidence != 0 ? withSortedEnds(stated) : stated;
  rows.push_back(row(glm::dvec3(cone.base), double{cone.baseRadius}));
  rows.push_back(row(glm::dvec3(cone.apex), context.index));
  rows.push_back({floatBits(cone.apexRadius), 0, 0, kindWord(scene, context, gpu::kKindCone)});
}

void appendShape(const scene::Plane& plane, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows) {
  const glm::dvec3 point(plane.p[0]);
  const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(plane.p[1]) - point, glm::dvec3(plane.p[2]) - point));
  rows.push_back(row(point, 0u));
  rows.push_back(row(normal, context.index));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindPlane)});
}

// Appends the records of one primitive.
void appendPrimitive(const scene::Scene& scene, const PrimitiveContext& context, Rows& rows) {
  std::visit([&](const auto& shape) { appendShape(shape, scene, context, rows); }, shapeOf(scene, context.primitive));
}

// Returns the geometries of the runs whose triangles belong to no instance, by run.
std::vector<std::uint32_t> geometriesOfRuns(const scene::Scene& scene, const std::vector<bool>& isInstance,
                                            Geometries& geometries) {
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  std::vector<std::uint32_t> numbers(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool isOwn = isInstance.empty() || !isInstance[i];
    if (isOwn && runs[i].start.kind == scene::PrimitiveKind::triangle) numbers[i] = geometries.ofRun(runs[i]);
  }
  return numbers;
}

std::size_t indexOf(const scene::Scene& scene, const scene::PrimitiveRun& run) {
  return static_cast<std::size_t>(&run - scene.primitives.runs().data());
}

// Returns for each primitive in the light table what its records refer to: for a sphere its light + 1, for a triangle
// its geometry.
std::unordered_map<std::uint32_t, std::uint32_t> referencesOfLights(const scene::Scene& scene,
                                                                    std::span<const LightEntry> table,
                                                                    std::span<const std::uint32_t> geometriesOfRuns,
                                                                    Geometries& geometries) {
  std::unordered_map<std::uint32_t, std::uint32_t> references;
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    if (!table[i].isEmitter() || table[i].isInstance()) continue;
    const std::uint32_t primitive = table[i].index, light = i + 1;
    const std::size_t run = indexOf(scene, scene.primitives.runOf(primitive));
    references[primitive] = table[i].kind == LightKind::triangle
                                ? geometries.ofLight(geometriesOfRuns[run], primitive, light)
                                : light;
  }
  return references;
}

}  // namespace

void placeSphere(const scene::Sphere& sphere, const glm::vec3& eye, std::span<gpu::uvec4, 2> rows) {
  const glm::dvec3 centre(sphere.centre);
  const double radius = std::abs(double{sphere.radius});
  const glm::dvec3 anchor = sphereAnchor(glm::dvec3(eye), centre, radius);
  const glm::dvec3 k = radius > 0 ? (anchor - centre) / radius : glm::dvec3(0);
  rows[0] = row(anchor, radius);
  rows[1] = row(k, rows[1].w);
}

void appendPrimitives(const scene::Scene& scene, const SlotOrder& order, std::span<const LightEntry> table,
                      const PrimitiveMarks& marks, const render::ImageSettings& image, FlatScene& flat) {
  const scene::StoredPrimitives stored(scene.primitives);
  Geometries geometries(scene, image.layers.has(image::Layer::uv), flat.shape.features.longCorners);
  std::vector<std::uint32_t> ofRuns = geometriesOfRuns(scene, order.isInstance, geometries);
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    if (!table[i].isInstance()) continue;
    std::uint32_t& geometry = ofRuns[indexOf(scene, scene.primitives.runOf(table[i].index))];
    geometry = geometries.ofLightInstance(geometry, table[i].index, i + 1);
  }
  const auto references = referencesOfLights(scene, table, ofRuns, geometries);
  std::vector<std::uint32_t> ofPrototypes;
  std::size_t slotCount = order.own.size();
  for (const std::vector<std::uint32_t>& prototype : order.ofPrototypes) {
    ofPrototypes.push_back(geometries.ofPrototype(scene.primitives.runOf(prototype.front())));
    slotCount += prototype.size();
  }
  // A vector that grows would copy the records of large meshes several times.
  flat.rows.reserve(flat.rows.size() + slotCount * gpu::kPrimitiveRows + geometries.countRows());
  flat.constants.firstPrimitiveRow = rowCount(flat.rows);
  const auto append = [&](std::uint32_t primitive, const scene::Primitive& entry, std::uint32_t index,
                          std::uint32_t geometry) {
    const std::uint32_t number = stored.indexOf(primitive);
    const bool emits = isEmissive(scene.materials[entry.material]);
    const auto light = emits ? references.find(primitive) : references.end();
    const PrimitiveContext context{
        .primitive = entry,
        .index = index,
        .reference = light == references.end() ? geometry : light->second,
        .touched = marks.touched[number],
        .coincidence = marks.coincident[number] ? coincidenceFlags(scene, entry, image.integrator) : 0,
        .ordered = marks.ordered[number] && !emits};
    appendPrimitive(scene, context, flat.rows);
  };
  for (const std::uint32_t primitive : order.own) {
    const scene::PrimitiveRun& run = scene.primitives.runOf(primitive);
    append(primitive, run.at(primitive), primitive, ofRuns[indexOf(scene, run)]);
  }
  for (std::size_t i = 0; i < order.ofPrototypes.size(); ++i) {
    const scene::PrimitiveRun& run = scene.primitives.runOf(order.ofPrototypes[i].front());
    for (const std::uint32_t primitive : order.ofPrototypes[i]) {
      scene::Primitive entry = run.at(primitive);
      entry.placement = scene::Primitive::kUnplaced;
      append(primitive, entry, primitive - run.first, ofPrototypes[i]);
    }
  }
  geometries.append(flat);
}

void copySlotRows(FlatScene& flat) {
  flat.shape.uniformSlots = flat.shape.slotCount;
  const auto first = flat.rows.begin() + flat.constants.firstPrimitiveRow;
  std::copy_n(first, flat.shape.uniformSlots * gpu::kPrimitiveRows, flat.slotRows.begin());
  for (std::uint32_t slot = 0; slot < flat.shape.uniformSlots; ++slot) {
    const std::uint32_t kindAndFlags = first[slot * gpu::kPrimitiveRows + 2].w & 0xffu;
    flat.shape.uniformKinds[slot / 4] |= kindAndFlags << 8 * (slot % 4);
  }
}

}  // namespace candela::flatten
