// Intersects rays by brute force, through the BVH, and through the grid.
#include "host/reference/tracing.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "host/reference/opacity.h"

namespace candela::reference {
namespace {

// The computed distances of a hit and of the box that contains it may have errors of opposite sign.
constexpr double kSlack = 1 + 1e-12;

// Twice the relative error of a distance by rounding.
constexpr double kTie = 2 * kRoundingBounds.hitDistance * kRoundoff;

dvec3 inverseOf(const dvec3& direction) {
  dvec3 inverse;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = direction[axis];
    inverse[axis] = std::abs(d) > 1e-300 ? 1 / d : std::copysign(1e300, d);  // so that 0 times it is 0
  }
  return inverse;
}

bool intersects(const Bounds& box, const dvec3& origin, const dvec3& inverse, double limit) {
  const dvec3 a = (box.min - origin) * inverse;
  const dvec3 b = (box.max - origin) * inverse;
  const dvec3 low = glm::min(a, b);
  const dvec3 high = glm::max(a, b);
  const double entry = std::max(std::max(low.x, low.y), std::max(low.z, 0.0));
  const double exit = std::min(std::min(high.x, high.y), high.z);
  return entry <= exit * kSlack && entry <= limit * kSlack;
}

// Rays of replicas are displaced, by far less than this, and may hit points just outside of a primitive's box.
void padForReplicas(std::vector<Bounds>& boxes, const dvec3& eye) {
  constexpr double kPadding = 0x1p-16;
  dvec3 largest = glm::abs(eye);
  for (const Bounds& box : boxes) largest = glm::max(largest, glm::max(glm::abs(box.min), glm::abs(box.max)));
  const dvec3 padding(kPadding * std::max({largest.x, largest.y, largest.z}));
  for (Bounds& box : boxes) box = {box.min - padding, box.max + padding};
}

bool isEverHit(const scene::Scene& scene, const scene::Primitive& primitive) {
  return primitive.kind != scene::PrimitiveKind::triangle ||
         TriangleShape(triangleOf(scene, primitive)).areaNormal() != dvec3(0);
}

// Returns the distance at which a ray hits a shape. A flat one-sided shape is not hit from its back.
struct HitDistance {
  const Ray& ray;
  bool startsHere;
  bool oneSided;

  double operator()(const SphereShape& sphere) const { return sphere.distance(ray, startsHere); }
  double operator()(const BoxShape& box) const { return box.distance(ray, startsHere); }
  double operator()(const ConeShape& cone) const { return cone.distance(ray, startsHere); }
  double operator()(const TriangleShape& triangle) const {
    return isPassed(oneSided ? triangle.areaNormal() : dvec3(0)) ? kNoHit : triangle.distance(ray);
  }
  double operator()(const PlaneShape& plane) const { return isPassed(plane.unitNormal) ? kNoHit : plane.distance(ray); }

  bool isPassed(const dvec3& normal) const { return startsHere || (oneSided && dot(ray.direction, normal) > 0); }
};

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
  volumeFaults += other.volumeFaults;
  traversalSteps += other.traversalSteps;
  return *this;
}

Tracing::Tracing(const scene::Scene& scene, const render::RenderSettings& settings)
    : Tracing(scene, settings, scene.camera ? dvec3(scene.camera->from) : dvec3(0)) {}

Tracing::Tracing(const scene::Scene& scene, const render::RenderSettings& settings, const dvec3& eye)
    : scene_(&scene), settings_(settings), eye_(eye) {
  const bool tracesReplicas = settings.execution.replicas > 0;
  const render::AccelKind accel = tracesReplicas ? render::AccelKind::bvh : settings.structure.accel;
  std::vector<Bounds> boxes;
  std::vector<std::uint32_t> bounded;
  std::vector<std::uint32_t> unbounded;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (!isEverHit(scene, scene.primitives[i])) continue;
    const std::optional<Bounds> bounds = boundsOf(scene, scene.primitives[i]);
    (bounds ? bounded : unbounded).push_back(i);
    if (bounds) boxes.push_back(*bounds);
  }
  if (tracesReplicas) padForReplicas(boxes, eye_);
  const auto add = [&](std::uint32_t primitive) {
    const scene::Material& material = scene.materials[scene.primitives[primitive].material];
    addItem(scene, primitive, settings.image.oneSided && material.opaque);
  };

  items_.reserve(scene.primitives.size());
  const bool wantsHierarchy = settings.structure.bvhSplit == render::BvhSplit::midpoint ||
                              bounded.size() > kBruteForceLimit;
  if (accel == render::AccelKind::bvh && wantsHierarchy) {
    hierarchy_ = buildHierarchy(boxes, settings.structure.bvhSplit);
    for (const std::uint32_t item : hierarchy_.order) add(bounded[item]);
  } else {
    for (const std::uint32_t primitive : bounded) add(primitive);
  }
  if (accel == render::AccelKind::grid) grid_ = buildGrid(boxes, double{settings.structure.gridDensity});
  if (hasHierarchy() || hasGrid()) firstOutside_ = items_.size();
  for (const std::uint32_t primitive : unbounded) add(primitive);
  if (tracesReplicas) findReaches();
}

void Tracing::setEye(const dvec3& eye) {
  if (settings_.execution.replicas > 0) {
    *this = Tracing(*scene_, settings_, eye);
  } else {
    eye_ = eye;
  }
}

void Tracing::findReaches() {
  for (const Item& item : items_) reaches_.push_back(roundingReach(item.shape, eye_));
}

void Tracing::addItem(const scene::Scene& scene, std::uint32_t index, bool oneSided) {
  const scene::Primitive& primitive = scene.primitives[index];
  items_.push_back({preparedShape(scene, primitive), oneSided, isTransparent(scene, primitive), index});
}

double Tracing::distance(const Item& item, const Ray& ray) const {
  return std::visit(HitDistance{ray, item.primitive == ray.originPrimitive, item.oneSided}, item.shape);
}

bool Tracing::passes(const Item& item, const Ray& ray, std::uint64_t word) const {
  if (!item.transparent) return false;
  dvec2 errorSign(0);
  if (word != 0) errorSign = {Rounding::signOf(word, item.primitive), Rounding::signOf(~word, item.primitive)};
  return !isThere(*scene_, item.primitive, ray, errorSign);
}

// Calls visit(item) for the items that a ray may hit before `limit`, which `visit` may reduce. Ends when `visit`
// returns true.
template <class Visit>
void Tracing::visitItems(const Ray& ray, const double& limit, Counters& counters, Visit&& visit) const {
  if (hasHierarchy() && visitHierarchy(ray, limit, counters, visit)) return;
  const bool throughGrid = hasGrid() && grid_.serves(ray.origin);
  if (throughGrid && visitGrid(ray, limit, counters, visit)) return;
  for (std::size_t i = hasGrid() && !throughGrid ? 0 : firstOutside_; i < items_.size(); ++i) {
    ++counters.traversalSteps;
    if (visit(items_[i])) return;
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
    if (!intersects(node.bounds, ray.origin, inverse, limit)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      ++counters.traversalSteps;
      if (visit(items_[i])) return true;
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
  for (GridTraversal traversal(grid_, ray); traversal.isInside(); traversal.advance()) {
    ++counters.traversalSteps;
    for (const std::uint32_t item : grid_.itemsOf(traversal.cell())) {
      ++counters.traversalSteps;
      if (visit(items_[item])) return true;
    }
    if (limit < traversal.exit()) return false;
  }
  return false;
}

Hit Tracing::closest(const Ray& ray, Counters& counters) const {
  Hit nearest;
  visitItems(ray, nearest.distance, counters, [&](const Item& item) {
    const double itemDistance = distance(item, ray);
    const bool nearer = itemDistance < nearest.distance;
    const bool wins = itemDistance == nearest.distance && itemDistance < kNoHit && item.primitive < nearest.primitive;
    if ((nearer || wins) && !passes(item, ray, 0)) nearest = {itemDistance, item.primitive};
    return false;
  });
  return nearest;
}

bool Tracing::containsLight(const Item& item, const Ray& ray, double t, const RayEnd& end, double fraction) const {
  if (!end.point) return false;
  const LightMargin margin(ray, end.distance, *end.point, eye_, fraction);
  const bool startsHere = item.primitive == ray.originPrimitive;
  return std::visit([&](const auto& shape) { return margin.contains(shape, t, startsHere); }, item.shape);
}

bool Tracing::isOccluded(const Ray& ray, const RayEnd& end, Counters& counters) const {
  bool occluded = false;
  visitItems(ray, end.distance, counters, [&](const Item& item) {
    if (item.primitive == end.light) return false;
    const double t = distance(item, ray);
    occluded = t < end.distance && !passes(item, ray, 0) && !containsLight(item, ray, t, end, kLightMargin);
    return occluded;
  });
  return occluded;
}

dvec3 Tracing::testedOrigin(const Item& item, const dvec3& origin, const dvec3& signs) const {
  return origin + reaches_[static_cast<std::size_t>(&item - items_.data())].at(origin) * signs;
}

Hit Tracing::closest(Ray& ray, Counters& counters, Rounding& rounding) const {
  if (!rounding.perturbs()) return closest(std::as_const(ray), counters);
  const dvec3 signs = rounding.signs();
  const std::uint64_t word = rounding.word();
  Hit nearest;
  dvec3 hitOrigin = ray.origin;
  Ray tested = ray;
  visitItems(ray, nearest.distance, counters, [&](const Item& item) {
    tested.origin = testedOrigin(item, ray.origin, signs);
    const double exact = distance(item, tested);
    if (!(exact < nearest.distance * (1 + kTie))) return false;
    const double rounded = exact * (1 + kTie / 2 * Rounding::signOf(word, item.primitive));
    if (!(rounded < nearest.distance) || passes(item, tested, word)) return false;
    nearest = {rounded, item.primitive};
    hitOrigin = tested.origin;
    return false;
  });
  ray.origin = hitOrigin;
  return nearest;
}

bool Tracing::isOccluded(const Ray& ray, const RayEnd& end, Counters& counters, Rounding& rounding) const {
  if (!rounding.perturbs()) return isOccluded(ray, end, counters);
  const dvec3 signs = rounding.signs();
  const std::uint64_t word = rounding.word();
  bool occluded = false;
  Ray tested = ray;
  visitItems(ray, end.distance, counters, [&](const Item& item) {
    if (item.primitive == end.light) return false;
    tested.origin = testedOrigin(item, ray.origin, signs);
    const double t = distance(item, tested);
    const double sign = Rounding::signOf(word, item.primitive);
    const double fraction = kLightMargin + sign * kRoundingBounds.lightDepth * kRoundoff;
    occluded = t < end.distance * (1 - kTie / 2 * sign) && !passes(item, tested, word) &&
               !containsLight(item, tested, t, end, fraction);
    return occluded;
  });
  return occluded;
}

}  // namespace candela::reference
