// Intersects rays by brute force, through the BVH, and through the grid.
#include "host/reference/tracing.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace candela::reference {
namespace {

// The computed distances of a hit and of the box that contains it may have errors of opposite sign.
constexpr double kSlack = 1 + 1e-12;

dvec3 inverseOf(const dvec3& direction) {
  dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    inverse[axis] = std::abs(d) > 1e-300 ? 1 / d : std::copysign(1e300, d);  // so that 0 times it is 0
  }
  return inverse;
}

bool meets(const Bounds& box, const dvec3& origin, const dvec3& inverse, double limit) {
  const dvec3 a = (box.min - origin) * inverse;
  const dvec3 b = (box.max - origin) * inverse;
  const dvec3 low = glm::min(a, b);
  const dvec3 high = glm::max(a, b);
  const double entry = std::max(std::max(low.x, low.y), std::max(low.z, 0.0));
  const double exit = std::min(std::min(high.x, high.y), high.z);
  return entry <= exit * kSlack && entry <= limit * kSlack;
}

bool isEverHit(const scene::Scene& scene, const scene::Primitive& primitive) {
  return primitive.kind != scene::PrimitiveKind::triangle ||
         TriangleShape(triangleOf(scene, primitive)).areaNormal() != dvec3(0);
}

}  // namespace

Counters& Counters::operator+=(const Counters& other) {
  samples += other.samples;
  cameraRays += other.cameraRays;
  bounceRays += other.bounceRays;
  cameraHits += other.cameraHits;
  reflectedRays += other.reflectedRays;
  refractedRays += other.refractedRays;
  shadowRays += other.shadowRays;
  vertices += other.vertices;
  traversalSteps += other.traversalSteps;
  return *this;
}

Tracing::Tracing(const scene::Scene& scene, const render::RenderSettings& settings) {
  std::vector<Bounds> boxes;
  std::vector<std::uint32_t> bounded;
  std::vector<std::uint32_t> unbounded;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (!isEverHit(scene, scene.primitives[i])) continue;
    const std::optional<Bounds> bounds = boundsOf(scene, scene.primitives[i]);
    (bounds ? bounded : unbounded).push_back(i);
    if (bounds) boxes.push_back(*bounds);
  }
  const auto add = [&](std::uint32_t primitive) {
    const scene::Material& material = scene.materials[scene.primitives[primitive].material];
    addItem(scene, primitive, settings.image.oneSided && material.opaque);
  };

  items_.reserve(scene.primitives.size());
  const bool wantsHierarchy = settings.structure.bvhSplit == render::BvhSplit::midpoint ||
                              bounded.size() > kBruteForceLimit;
  if (settings.structure.accel == render::AccelKind::bvh && wantsHierarchy) {
    hierarchy_ = buildHierarchy(boxes, settings.structure.bvhSplit);
    for (const std::uint32_t place : hierarchy_.order) add(bounded[place]);
  } else {
    for (const std::uint32_t primitive : bounded) add(primitive);
  }
  if (settings.structure.accel == render::AccelKind::grid)
    grid_ = buildGrid(boxes, double{settings.structure.gridDensity});
  if (hasHierarchy() || hasGrid()) firstOutside_ = items_.size();
  for (const std::uint32_t primitive : unbounded) add(primitive);
}

void Tracing::addItem(const scene::Scene& scene, std::uint32_t primitive, bool oneSided) {
  const scene::PrimitiveKind kind = scene.primitives[primitive].kind;
  const std::uint32_t index = scene.primitives[primitive].index;
  const auto append = [&](auto& shapes, const auto& source) {
    shapes.emplace_back(source);
    items_.push_back({kind, oneSided, static_cast<std::uint32_t>(shapes.size() - 1), primitive});
  };
  switch (kind) {
    case scene::PrimitiveKind::sphere:
      return append(spheres_, scene.spheres[index]);
    case scene::PrimitiveKind::triangle:
      return append(triangles_, triangleOf(scene, scene.primitives[primitive]));
    case scene::PrimitiveKind::box:
      return append(boxes_, scene.boxes[index]);
    case scene::PrimitiveKind::cone:
      return append(cones_, scene.cones[index]);
    case scene::PrimitiveKind::plane:
      return append(planes_, scene.planes[index]);
  }
}

double Tracing::distance(const Item& item, const Ray& ray) const {
  const bool leaving = item.primitive == ray.leaving;
  const auto flat = [&](const auto& shape, const dvec3& normal) {
    if (leaving || (item.oneSided && dot(ray.direction, normal) > 0)) return kNoHit;
    return shape.distance(ray);
  };
  switch (item.kind) {
    case scene::PrimitiveKind::sphere:
      return spheres_[item.shape].distance(ray, leaving);
    case scene::PrimitiveKind::triangle: {
      const TriangleShape& triangle = triangles_[item.shape];
      return flat(triangle, item.oneSided ? triangle.areaNormal() : dvec3(0));
    }
    case scene::PrimitiveKind::box:
      return boxes_[item.shape].distance(ray, leaving);
    case scene::PrimitiveKind::cone:
      return cones_[item.shape].distance(ray, leaving);
    case scene::PrimitiveKind::plane:
      return flat(planes_[item.shape], planes_[item.shape].unitNormal);
  }
  return kNoHit;
}

// Calls visit(item, distance of its box) for the items that a ray may hit before `limit`, which `visit` may reduce.
// Ends when `visit` returns true.
template <class Visit>
void Tracing::visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  if (hasHierarchy() && visitHierarchy(ray, limit, counters, visit)) return;
  const bool throughGrid = hasGrid() && grid_.serves(ray.origin);
  if (throughGrid && visitGrid(ray, limit, counters, visit)) return;
  for (std::size_t i = hasGrid() && !throughGrid ? 0 : firstOutside_; i < items_.size(); ++i) {
    ++counters.traversalSteps;
    if (visit(items_[i], distance(items_[i], ray))) return;
  }
}

template <class Visit>
bool Tracing::visitHierarchy(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  const dvec3 inverse = inverseOf(ray.direction);
  std::array<std::uint32_t, Hierarchy::kMaxDepth + 1> stack;
  std::uint32_t stackSize = 0;
  stack[stackSize++] = 0;
  while (stackSize > 0) {
    const std::uint32_t index = stack[--stackSize];
    const Node& node = hierarchy_.nodes[index];
    ++counters.traversalSteps;
    if (!meets(node.bounds, ray.origin, inverse, limit)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      ++counters.traversalSteps;
      if (visit(items_[i], distance(items_[i], ray))) return true;
    }
    if (node.count > 0) continue;
    const bool forward = ray.direction[node.axis] >= 0;
    stack[stackSize++] = forward ? node.first : index + 1;
    stack[stackSize++] = forward ? index + 1 : node.first;
  }
  return false;
}

// A hit within a cell belongs to an item of the cell. Therefore the closest hit is final once it is before the exit
// from the cell.
template <class Visit>
bool Tracing::visitGrid(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  for (GridWalk walk(grid_, ray); walk.isInside(); walk.advance()) {
    ++counters.traversalSteps;
    for (const std::uint32_t item : grid_.itemsOf(walk.cell())) {
      ++counters.traversalSteps;
      if (visit(items_[item], distance(items_[item], ray))) return true;
    }
    if (limit < walk.exit()) return false;
  }
  return false;
}

Hit Tracing::closest(const Ray& ray, Counters& counters) const {
  Hit nearest;
  visitItems(ray, nearest.distance, counters, [&](const Item& item, double distance) {
    const bool nearer = distance < nearest.distance;
    const bool wins = distance == nearest.distance && distance < kNoHit && item.primitive < nearest.primitive;
    if (nearer || wins) nearest = {distance, item.primitive};
    return false;
  });
  return nearest;
}

bool Tracing::isOccluded(const Ray& ray, double distance, std::uint32_t light, Counters& counters) const {
  bool occluded = false;
  visitItems(ray, distance, counters, [&](const Item& item, double itemDistance) {
    occluded = item.primitive != light && itemDistance < distance;
    return occluded;
  });
  return occluded;
}

}  // namespace candela::reference
