// Intersects rays by brute force, through the BVH, and through the grid.
#include "host/reference/tracing.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "host/reference/coincidence.h"
#include "host/reference/opacity.h"
#include "host/scene/coincidence.h"

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

// Rays of replicas are displaced, and rays that cross a surface hit what coincides with it. Both may hit points outside
// of a primitive's box, by far less than this.
void pad(std::vector<Bounds>& boxes, const dvec3& eye) {
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

bool transmits(const scene::Material& material, bool whitted) {
  if (whitted) return material.whitted && material.whitted->kind == scene::WhittedKind::glass;
  return material.dielectric || (material.surface && material.surface->transmissionWeight > 0);
}

// Returns the distance at which a ray hits a shape. A flat one-sided shape is not hit from its back.
struct HitDistance {
  const Ray& ray;
  bool startsHere;
  bool oneSided;
  const Shape* origin;   // of another primitive, on which the ray starts
  bool passesSameSide;   // a ray that starts on a surface that coincides with this one passes it: on the side on which
  bool passesOtherSide;  // it entered or exited its origin primitive, and on the opposite side

  double operator()(const SphereShape& sphere) const {
    if (!origin || !isSame(*origin, sphere)) return sphere.distance(ray, startsHere);
    const bool isHit = sphere.radius > 0 || dot(ray.direction, ray.at(0) - sphere.centre) > 0;
    const bool isSameSide = std::get<SphereShape>(*origin).radius == sphere.radius;
    return passes(isSameSide) || !isHit ? sphere.distance(ray, true) : kAtOnce;
  }
  double operator()(const ConeShape& cone) const {
    if (!origin || !isSame(*origin, cone)) return cone.distance(ray, startsHere);
    return passes(true) ? cone.distance(ray, true) : kAtOnce;
  }
  double operator()(const BoxShape& box) const {
    if (!origin) return box.distance(ray, startsHere);
    if (isSame(*origin, box)) return passes(true) ? box.distance(ray, true) : kAtOnce;
    const BoxShape::Crossings line = box.crossings(ray);
    if (line.misses()) return kNoHit;
    const FlatSurface entered(box, line.entryNormal(ray));
    const FlatSurface exited(box, line.exitNormal(ray));
    if (isInPlaneOfOrigin(exited)) return passes(isSameSide(exited.normal)) ? kNoHit : kAtOnce;
    if (isInPlaneOfOrigin(entered)) return passes(isSameSide(entered.normal)) ? positiveOrNoHit(line.exit) : kAtOnce;
    return positiveOrNoHit(line.entry > 0 ? line.entry : line.exit);
  }
  double operator()(const TriangleShape& triangle) const { return flatDistance(triangle, triangle.areaNormal()); }
  double operator()(const PlaneShape& plane) const { return flatDistance(plane, plane.unitNormal); }

  template <class Flat>
  double flatDistance(const Flat& shape, const dvec3& normal) const {
    if (startsHere || (oneSided && dot(ray.direction, normal) > 0)) return kNoHit;
    const bool isInPlane = origin && shape.lineDistance(ray) != kNoHit && isInPlaneOfOrigin(FlatSurface(shape));
    if (!isInPlane) return shape.distance(ray);
    return passes(isSameSide(normal)) ? kNoHit : kAtOnce;
  }

  bool isInPlaneOfOrigin(const FlatSurface& surface) const {
    const std::optional<FlatSurface> start = flatOrigin(*origin, ray);
    return start && areCoplanar(*start, surface);
  }
  bool isSameSide(const dvec3& normal) const {
    return (dot(ray.direction, normal) < 0) == (dot(ray.direction, ray.originNormal) < 0);
  }
  bool passes(bool isSameSide) const { return isSameSide ? passesSameSide : passesOtherSide; }
};

// A hit as it is compared with others. Of equal distances, those behind emitters come last, then the higher indices.
struct Candidate {
  double distance = kNoHit;
  bool behind = true;
  std::uint32_t primitive = kNoPrimitive;

  auto operator<=>(const Candidate&) const = default;
};

// Returns the cosine of the angle between a ray and the normal of a flat shape that it hits at distance t; 0 for
// others.
struct FlatCosine {
  const Ray& ray;
  double t;

  double operator()(const TriangleShape& triangle) const { return of(normalize(triangle.areaNormal())); }
  double operator()(const PlaneShape& plane) const { return of(plane.unitNormal); }
  double operator()(const BoxShape& box) const {
    const BoxShape::Crossings line = box.crossings(ray);
    const bool enters = std::abs(t - line.entry) <= std::abs(t - line.exit);
    return of(enters ? line.entryNormal(ray) : line.exitNormal(ray));
  }
  double operator()(const SphereShape&) const { return 0; }
  double operator()(const ConeShape&) const { return 0; }

  double of(const dvec3& normal) const { return std::abs(dot(normal, ray.direction)); }
};

bool hasEmissivePrimitive(const scene::Scene& scene) {
  return std::ranges::any_of(scene.primitives, [&](const scene::Primitive& primitive) {
    return isEmissive(scene.materials[primitive.material]);
  });
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
  const bool whitted = settings.image.integrator == render::Integrator::whitted;
  const auto isCrossed = [&](const scene::Material& material) { return transmits(material, whitted); };
  if (tracesReplicas || std::ranges::any_of(scene.materials, isCrossed)) pad(boxes, eye_);
  scene::Coincidences coincidences;
  if (hasEmissivePrimitive(scene)) coincidences = scene::findCoincidences(scene);
  behindReach_ = double{coincidences.behindReach};
  const auto add = [&](std::uint32_t primitive) {
    const scene::Material& material = scene.materials[scene.primitives[primitive].material];
    addItem(scene, primitive, settings.image.oneSided && material.opaque,
            behindReach_ > 0 && coincidences.behind[primitive]);
  };

  items_.reserve(scene.primitives.size());
  itemOf_.resize(scene.primitives.size());
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
  if (tracesReplicas) prepareReplicas();
}

void Tracing::setEye(const dvec3& eye) {
  if (settings_.execution.replicas > 0) {
    *this = Tracing(*scene_, settings_, eye);
  } else {
    eye_ = eye;
  }
}

void Tracing::prepareReplicas() {
  const std::vector<std::uint32_t> firstCopy = scene::firstCopies(*scene_);
  for (Item& item : items_) item.firstCopy = firstCopy[item.primitive];
  for (const Item& item : items_) reaches_.push_back(roundingReach(item.shape, eye_));
}

void Tracing::addItem(const scene::Scene& scene, std::uint32_t index, bool oneSided, bool behind) {
  const scene::Primitive& primitive = scene.primitives[index];
  const scene::Material& material = scene.materials[primitive.material];
  const bool thinWalled = material.surface && !material.surface->hasVolume();
  const bool whitted = settings_.image.integrator == render::Integrator::whitted;
  itemOf_[index] = static_cast<std::uint32_t>(items_.size());
  items_.push_back({preparedShape(scene, primitive), oneSided, isTransparent(scene, primitive), isEmissive(material),
                    transmits(material, whitted), thinWalled, behind, primitive.material, index, index});
}

double Tracing::distance(const Item& item, const Ray& ray) const {
  const bool startsHere = item.primitive == ray.originPrimitive;
  const bool startsElsewhere = !startsHere && ray.originPrimitive != kNoPrimitive;
  const Item* const origin = startsElsewhere ? &items_[itemOf_[ray.originPrimitive]] : nullptr;
  const bool isContinued = origin && item.transmits && item.material == origin->material;
  bool passesSameSide = true;
  bool passesOtherSide = true;
  if (origin && ray.crosses && ray.contact != Contact::back) {
    const bool isBehind = item.transmits && item.primitive < origin->primitive;
    passesSameSide = isBehind || isContinued;
    passesOtherSide = isBehind || (isContinued && item.thinWalled);
  } else if (origin && !ray.crosses && ray.contact != Contact::none) {
    passesSameSide = passesOtherSide = isContinued || (ray.contact == Contact::beyond && !item.transmits);
  }
  return std::visit(
      HitDistance{ray, startsHere, item.oneSided, origin ? &origin->shape : nullptr, passesSameSide, passesOtherSide},
      item.shape);
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

double Tracing::comparedDistance(const Item& item, const Ray& ray, double t) const {
  if (!item.behind || t == kNoHit) return t;
  if (isAtOnce(t)) return 2 * t;
  const double cosine = std::visit(FlatCosine{ray, t}, item.shape);
  const dvec3 origin = abs(ray.origin);
  const double reach = std::max({behindReach_, origin.x, origin.y, origin.z});
  return cosine > 0 ? std::min(t + 2 * kCoplanar * reach / cosine, kNoHit / 2) : t;
}

Hit Tracing::closest(const Ray& ray, Counters& counters) const {
  Hit nearest;
  Candidate best;
  visitItems(ray, best.distance, counters, [&](const Item& item) {
    const double exact = distance(item, ray);
    const Candidate candidate{comparedDistance(item, ray, exact), item.behind, item.primitive};
    if (!(candidate < best) || exact == kNoHit || passes(item, ray, 0)) return false;
    best = candidate;
    nearest = {exact, item.primitive};
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

std::optional<bool> Tracing::hidesEmitter(const Item& item, double t, const Item& light, double lightDistance) const {
  if (!item.emits || !coincide(item.shape, light.shape)) return std::nullopt;
  return t < lightDistance || (t == lightDistance && item.primitive < light.primitive);
}

bool Tracing::isOccluded(const Ray& ray, const RayEnd& end, Counters& counters) const {
  const Item* const light = end.light == kNoPrimitive ? nullptr : &items_[itemOf_[end.light]];
  bool occluded = false;
  visitItems(ray, end.distance, counters, [&](const Item& item) {
    if (&item == light) return false;
    const double t = distance(item, ray);
    if (t == kNoHit || passes(item, ray, 0)) return false;
    const std::optional<bool> hides = light ? hidesEmitter(item, t, *light, distance(*light, ray)) : std::nullopt;
    occluded = hides.value_or(t < end.distance && !containsLight(item, ray, t, end, kLightMargin));
    return occluded;
  });
  return occluded;
}

dvec3 Tracing::testedOrigin(const Item& item, const dvec3& origin, const dvec3& signs) const {
  return origin + reaches_[static_cast<std::size_t>(&item - items_.data())].at(origin) * signs;
}

double Tracing::roundedDistance(const Item& item, double exact, std::uint64_t word) const {
  return exact * (1 + kTie / 2 * Rounding::signOf(word, item.firstCopy));
}

Hit Tracing::closest(Ray& ray, Counters& counters, Rounding& rounding) const {
  if (!rounding.perturbs()) return closest(std::as_const(ray), counters);
  const dvec3 signs = rounding.signs();
  const std::uint64_t word = rounding.word();
  Hit nearest;
  Candidate best;
  dvec3 hitOrigin = ray.origin;
  Ray tested = ray;
  visitItems(ray, best.distance, counters, [&](const Item& item) {
    tested.origin = testedOrigin(item, ray.origin, signs);
    const double exact = distance(item, tested);
    if (!(exact < best.distance * (1 + kTie))) return false;
    const double rounded = roundedDistance(item, exact, word);
    const Candidate candidate{comparedDistance(item, tested, rounded), item.behind, item.primitive};
    if (!(candidate < best) || passes(item, tested, word)) return false;
    best = candidate;
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
  const Item* const light = end.light == kNoPrimitive ? nullptr : &items_[itemOf_[end.light]];
  bool occluded = false;
  Ray tested = ray;
  const auto ofLight = [&] {
    Ray toLight = ray;
    toLight.origin = testedOrigin(*light, ray.origin, signs);
    return roundedDistance(*light, distance(*light, toLight), word);
  };
  visitItems(ray, end.distance, counters, [&](const Item& item) {
    if (&item == light) return false;
    tested.origin = testedOrigin(item, ray.origin, signs);
    const double t = distance(item, tested);
    if (t == kNoHit || passes(item, tested, word)) return false;
    const std::optional<bool> hides = light ? hidesEmitter(item, roundedDistance(item, t, word), *light, ofLight())
                                            : std::nullopt;
    const double sign = Rounding::signOf(word, item.firstCopy);
    const double fraction = kLightMargin + sign * kRoundingBounds.lightDepth * kRoundoff;
    occluded = hides.value_or(t < end.distance * (1 - kTie / 2 * sign) &&
                              !containsLight(item, tested, t, end, fraction));
    return occluded;
  });
  return occluded;
}

}  // namespace candela::reference
