// Stores primitives and attributes as 16-byte records.
#include "host/trace/flatten/flatten_primitives.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"

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
  return kindAndFlags | touched | opaque | context.coincidence | primitive.material << gpu::kMaterialShift;
}

std::uint32_t indexWord(const PrimitiveContext& context) {
  return context.index | (context.behind ? gpu::kIndexBehind : 0);
}

void appendShape(const scene::Sphere& sphere, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  const std::uint32_t inside = sphere.radius < 0 ? gpu::kFlagInsideOnly : 0;
  rows.push_back({});
  rows.push_back({0, 0, 0, indexWord(context)});
  placeSphere(sphere, scene.camera->from, std::span(rows).last<2>());
  rows.push_back({context.light, 0, 0, kindWord(scene, context, gpu::kKindSphere | inside)});
}

void appendShape(const scene::Triangle& triangle, const scene::Scene& scene, const PrimitiveContext& context,
                 Rows& rows, Rows& attributes) {
  const scene::Primitive& primitive = context.primitive;
  const std::uint32_t flags = attributeFlags(scene, context, primitive);
  const std::uint32_t passed = scene.materials[primitive.material].opacity ? gpu::kFlagTransparent : 0;
  const std::uint32_t extra = flags != 0 ? static_cast<std::uint32_t>(attributes.size()) : context.light;
  if (flags != 0) appendAttributes(scene, context, primitive, flags, attributes);
  rows.push_back(row(glm::dvec3(triangle.p[0]), extra));
  rows.push_back(row(glm::dvec3(triangle.p[1]), indexWord(context)));
  rows.push_back(row(glm::dvec3(triangle.p[2]), kindWord(scene, context, gpu::kKindTriangle | flags | passed)));
}

void appendShape(const scene::Box& box, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows, Rows&) {
  rows.push_back(row(glm::dvec3(box.min), 0u));
  rows.push_back(row(glm::dvec3(box.max), indexWord(context)));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindBox)});
}

// Equal cones with their ends in either order have equal distances if their records are equal.
void appendShape(const scene::Cone& stated, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  const scene::Cone cone = context.coincidence != 0 ? withSortedEnds(stated) : stated;
  rows.push_back(row(glm::dvec3(cone.base), double{cone.baseRadius}));
  rows.push_back(row(glm::dvec3(cone.apex), indexWord(context)));
  rows.push_back({floatBits(cone.apexRadius), 0, 0, kindWord(scene, context, gpu::kKindCone)});
}

void appendShape(const scene::Plane& plane, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  const glm::dvec3 point(plane.p[0]);
  const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(plane.p[1]) - point, glm::dvec3(plane.p[2]) - point));
  rows.push_back(row(point, 0u));
  rows.push_back(row(normal, indexWord(context)));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindPlane)});
}

// Appends the records of one primitive to `primitives`, and those of its vertices' attributes, if it has any, to
// `attributes`. A triangle refers to `attributes` by the index of a record within that section.
void appendPrimitive(const scene::Scene& scene, const PrimitiveContext& context, Rows& primitives, Rows& attributes) {
  std::visit([&](const auto& shape) { appendShape(shape, scene, context, primitives, attributes); },
             shapeOf(scene, context.primitive));
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
  std::unordered_map<std::uint32_t, std::uint32_t> lightOf;
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    if (table[i].isEmitter()) lightOf[table[i].index] = i + 1;
  }
  std::size_t slotCount = order.own.size();
  for (const std::vector<std::uint32_t>& prototype : order.ofPrototypes) slotCount += prototype.size();
  // Vectors that grow would copy the records of large meshes several times. Memory beyond the part in use is never
  // touched.
  const std::size_t attributeRows = slotCount * attributeRowsOf(flat.shape.features);
  Rows attributes;
  attributes.reserve(attributeRows);
  flat.rows.reserve(flat.rows.size() + slotCount * gpu::kPrimitiveRows + attributeRows);
  flat.constants.firstPrimitiveRow = rowCount(flat.rows);
  const auto append = [&](std::uint32_t primitive, const scene::Primitive& entry, std::uint32_t index) {
    const auto light = lightOf.find(primitive);
    const std::uint32_t number = stored.indexOf(primitive);
    const bool emits = isEmissive(scene.materials[entry.material]);
    const PrimitiveContext context{
        .primitive = entry,
        .index = index,
        .light = light == lightOf.end() ? 0 : light->second,
        .touched = marks.touched[number],
        .coincidence = marks.coincident[number] ? coincidenceFlags(scene, entry, image.integrator) : 0,
        .behind = marks.behind[number] && !emits,
        .keepsTexCoords = image.layers.has(image::Layer::uv)};
    appendPrimitive(scene, context, flat.rows, attributes);
  };
  for (const std::uint32_t primitive : order.own) append(primitive, scene.primitives[primitive], primitive);
  for (const std::vector<std::uint32_t>& prototype : order.ofPrototypes) {
    const scene::PrimitiveRun& run = scene.primitives.runOf(prototype.front());
    for (const std::uint32_t primitive : prototype) {
      scene::Primitive entry = run.at(primitive);
      entry.placement = scene::Primitive::kUnplaced;
      append(primitive, entry, primitive - run.first);
    }
  }
  flat.constants.firstAttributeRow = rowCount(flat.rows);
  flat.rows.insert(flat.rows.end(), attributes.begin(), attributes.end());
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
