// Intersects rays by brute force, through the BVH, and through the grid.
#include "host/trace/reference/tracing.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "host/scene/coincidence/coincidence.h"
#include "host/trace/reference/coincidence.h"
#include "host/trace/reference/opacity.h"
#include "host/trace/reference/visit_items.h"

namespace candela::reference {
namespace {

// Returns the largest coordinate of boxes and the eye.
double reachOf(std::span<const Bounds> boxes, const Instances& instances, const dvec3& eye) {
  dvec3 largest = glm::abs(eye);
  const auto extend = [&](const Bounds& box) {
    largest = glm::max(largest, glm::max(glm::abs(box.min), glm::abs(box.max)));
  };
  for (const Bounds& box : boxes) extend(box);
  for (const Instance& instance : instances.instances()) extend(instance.bounds());
  return std::max({largest.x, largest.y, largest.z});
}

bool transmits(const scene::Material& material, bool whitted) {
  if (whitted) return material.whitted && material.whitted->kind == scene::WhittedKind::glass;
  return scene::transmits(material);
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
    const bool exits = isInPlaneOfOrigin(exited);
    if (exits || isInPlaneOfOrigin(entered)) {
      const bool passed = passes(isSameSide(exits ? exited.normal : entered.normal));
      if (!passed && !box.crossings(normalAtOrigin()).misses()) return kAtOnce;
      return exits ? kNoHit : positiveOrNoHit(line.exit);
    }
    return positiveOrNoHit(line.entry > 0 ? line.entry : line.exit);
  }
  double operator()(const TriangleShape& triangle) const { return flatDistance(triangle, triangle.areaNormal()); }
  double operator()(const PlaneShape& plane) const { return flatDistance(plane, plane.unitNormal); }

  template <class Flat>
  double flatDistance(const Flat& shape, const dvec3& normal) const {
    if (startsHere || (oneSided && dot(ray.direction, normal) > 0)) return kNoHit;
    if (!origin) return shape.distance(ray);
    const bool hitsAtOnce = !passes(isSameSide(normal)) && shape.lineDistance(normalAtOrigin()) != kNoHit;
    if (!hitsAtOnce && shape.lineDistance(ray) == kNoHit) return kNoHit;
    if (!isInPlaneOfOrigin(FlatSurface(shape))) return shape.distance(ray);
    return hitsAtOnce ? kAtOnce : kNoHit;
  }

  // Returns the line that meets what is hit at once in the plane of the ray's origin. That of the ray may meet a
  // surface in this plane anywhere if it lies almost in the plane.
  Ray normalAtOrigin() const { return {ray.origin, ray.originNormal}; }
  bool isInPlaneOfOrigin(const FlatSurface& surface) const {
    const std::optional<FlatSurface> start = flatOrigin(*origin, ray);
    return start && areCoplanar(*start, surface);
  }
  bool isSameSide(const dvec3& normal) const {
    return (dot(ray.direction, normal) < 0) == (dot(ray.direction, ray.originNormal) < 0);
  }
  bool passes(bool isSameSide) const { return isSameSide ? passesSameSide : passesOtherSide; }
};

// Returns the cosine of the angle between a ray and the outward normal of a flat shape that it hits at distance t; 0
// for others.
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

  double of(const dvec3& normal) const { return dot(normal, ray.direction); }
};

// Returns the place of a surface in the order in a plane, apart from its emission, for a ray that enters or exits it.
int placeInPlane(const Tracing::Item& item, bool enters) {
  if (!item.transmits) return 3;
  if (item.thinWalled) return 2;
  const bool isCurved = std::holds_alternative<SphereShape>(item.shape) ||
                        std::holds_alternative<ConeShape>(item.shape);
  return enters && !isCurved ? 4 : 1;
}

// Returns whether a ray that starts on `origin` hits at once an item that coincides with it. `sameSide`: it enters both
// of them, or exits both.
bool hitsAtOnce(const Tracing::Item& item, const Ray& ray, const Tracing::Item& origin, bool sameSide) {
  if (!ray.crosses && ray.contact == Contact::none) return false;
  if (!item.transmits && ray.contact == Contact::back) return !ray.crosses;
  if (!item.transmits && !ray.crosses) return false;
  if (item.transmits && item.material == origin.material && (sameSide || item.thinWalled)) return false;
  // A ray that stays on its side goes back, and what comes first for the ray that arrived is hit.
  const bool entersOrigin = (dot(ray.direction, ray.originNormal) < 0) == ray.crosses;
  const std::pair here(placeInPlane(origin, entersOrigin), origin.primitive);
  const std::pair there(placeInPlane(item, entersOrigin == sameSide), item.primitive);
  return ray.crosses ? here < there : there < here;
}

bool hasEmissivePrimitive(const scene::Scene& scene) {
  return std::ranges::any_of(scene.primitives.runs(), [&](const scene::PrimitiveRun& run) {
    return isEmissive(scene.materials[run.start.material]);
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
  if (accel == render::AccelKind::bvh && !settings.structure.copiesInstances) {
    instances_ = Instances(scene, settings.structure.bvhSplit);
  }
  std::vector<Bounds> boxes;
  std::vector<std::uint32_t> bounded;
  std::vector<std::uint32_t> unbounded;
  for (std::size_t run = 0; run < scene.primitives.runs().size(); ++run) {
    if (instances_.contains(run)) continue;
    const scene::PrimitiveRun& copied = scene.primitives.runs()[run];
    for (std::uint32_t i = copied.first; i < copied.first + scene.primitives.countOf(copied); ++i) {
      if (!isEverHit(preparedShape(scene, copied.at(i)))) continue;
      const std::optional<Bounds> bounds = boundsOf(scene, copied.at(i));
      (bounds ? bounded : unbounded).push_back(i);
      if (bounds) boxes.push_back(*bounds);
    }
  }
  // Rays of replicas are displaced, and rays that cross a surface hit what coincides with it. Both may hit points
  // outside of a primitive's box, by far less than this.
  constexpr double kPadding = 0x1p-16;
  const bool whitted = settings.image.integrator == render::Integrator::whitted;
  const auto isCrossed = [&](const scene::Material& material) { return transmits(material, whitted); };
  double padding = 0;
  if (tracesReplicas || std::ranges::any_of(scene.materials, isCrossed)) {
    padding = kPadding * reachOf(boxes, instances_, eye_);
    for (Bounds& box : boxes) box = box.padded(padding);
  }
  instances_.build(padding);
  if (tracesReplicas || hasEmissivePrimitive(scene) || std::ranges::any_of(scene.materials, isCrossed)) {
    scene::Coincidences coincidences = scene::findCoincidences(scene);
    orderReach_ = double{coincidences.orderReach};
    if (orderReach_ > 0) ordered_ = std::move(coincidences.ordered);
    if (tracesReplicas) coincident_ = std::move(coincidences.coincident);
    if (tracesReplicas || orderReach_ > 0) stored_.emplace(scene.primitives);
  }

  items_.reserve(bounded.size() + unbounded.size());
  if (instances_.empty()) itemOf_.resize(scene.primitives.size());
  const auto add = [&](std::uint32_t primitive) {
    if (!itemOf_.empty()) itemOf_[primitive] = static_cast<std::uint32_t>(items_.size());
    items_.push_back(madeItem(scene.primitives[primitive], primitive));
  };
  const bool wantsHierarchy = settings.structure.bvhSplit == render::BvhSplit::midpoint ||
                              bounded.size() > kBruteForceLimit;
  if (accel == render::AccelKind::bvh && wantsHierarchy) {
    hierarchy_ = buildHierarchy(boxes, settings.structure.bvhSplit);
    for (const std::uint32_t item : hierarchy_.order) add(bounded[item]);
  } else {
    for (const std::uint32_t primitive : bounded) add(primitive);
  }
  if (accel == render::AccelKind::grid) grid_ = buildGrid(boxes, double{settings.structure.gridDensity});
  if (!hierarchy_.nodes.empty() || hasGrid()) firstOutside_ = items_.size();
  for (const std::uint32_t primitive : unbounded) add(primitive);
}

void Tracing::setEye(const dvec3& eye) {
  if (settings_.execution.replicas > 0) {
    *this = Tracing(*scene_, settings_, eye);
  } else {
    eye_ = eye;
  }
}

Tracing::Item Tracing::madeItem(const scene::Primitive& primitive, std::uint32_t index) const {
  const scene::Material& material = scene_->materials[primitive.material];
  const bool thinWalled = material.surface && !material.surface->hasVolume();
  const bool whitted = settings_.image.integrator == render::Integrator::whitted;
  const auto isCrossed = [&](const scene::Material& m) { return transmits(m, whitted); };
  const bool emits = isEmissive(material);
  return {preparedShape(*scene_, primitive),
          settings_.image.oneSided && material.opaque,
          isTransparent(*scene_, primitive),
          emits,
          anyMaterial(*scene_, primitive.material, isCrossed),
          thinWalled,
          !ordered_.empty() && ordered_[stored_->indexOf(index)] && !emits,
          primitive.material,
          index};
}

const Tracing::Item* Tracing::makeItem(std::uint32_t primitive, std::optional<Item>& made) const {
  return &made.emplace(madeItem(scene_->primitives[primitive], primitive));
}

double Tracing::distance(const Item& item, const Ray& ray, const Item* origin) const {
  const bool startsHere = item.primitive == ray.originPrimitive;
  if (startsHere) origin = nullptr;
  const bool passesSameSide = !origin || !hitsAtOnce(item, ray, *origin, true);
  const bool passesOtherSide = !origin || !hitsAtOnce(item, ray, *origin, false);
  return std::visit(
      HitDistance{ray, startsHere, item.oneSided, origin ? &origin->shape : nullptr, passesSameSide, passesOtherSide},
      item.shape);
}

bool Tracing::passes(const Item& item, const Ray& ray) const {
  return item.transparent && !isThere(*scene_, item.primitive, ray);
}

double Tracing::comparedDistance(const Item& item, const Ray& ray, double t) const {
  if (!item.ordered || t == kNoHit) return t;
  const double cosine = std::visit(FlatCosine{ray, t}, item.shape);
  if (cosine == 0) return t;
  const int place = placeInPlane(item, cosine < 0);
  if (isAtOnce(t)) return (1 + place) * t;
  const dvec3 origin = abs(ray.origin);
  const double reach = std::max({orderReach_, origin.x, origin.y, origin.z});
  return t + place * 2 * kCoplanar * reach / std::abs(cosine);
}

Hit Tracing::closest(const Ray& ray, Counters& counters) const {
  Hit nearest;
  Candidate best;
  std::optional<Item> made;
  const Item* const origin = itemOf(ray.originPrimitive, made);
  visitItems(ray, best.distance, counters, [&](const Item& item) {
    const double t = distance(item, ray, origin);
    const Candidate found = candidate(item, ray, t);
    if (!(found < best) || t == kNoHit || passes(item, ray)) return false;
    best = found;
    nearest = {t, item.primitive};
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
  std::optional<Item> madeOrigin, madeLight;
  const Item* const origin = itemOf(ray.originPrimitive, madeOrigin);
  const Item* const light = itemOf(end.light, madeLight);
  bool occluded = false;
  visitItems(ray, end.distance, counters, [&](const Item& item) {
    if (item.primitive == end.light) return false;
    const double t = distance(item, ray, origin);
    if (t == kNoHit || passes(item, ray)) return false;
    std::optional<bool> hides;
    if (light && item.emits) hides = hidesEmitter(item, t, *light, distance(*light, ray, origin));
    occluded = hides.value_or(t < end.distance && !containsLight(item, ray, t, end, kLightMargin));
    return occluded;
  });
  return occluded;
}

}  // namespace candela::reference
