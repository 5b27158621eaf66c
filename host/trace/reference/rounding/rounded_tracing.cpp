// Tests each primitive with a ray of its own.
#include "host/trace/reference/rounding/rounded_tracing.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "host/base/hash.h"
#include "host/scene/coincidence/coincidence.h"
#include "host/trace/reference/opacity.h"
#include "host/trace/reference/rounding/bounds.h"
#include "host/trace/reference/visit_items.h"

namespace candela::reference {
namespace {

// Twice the relative error of a distance by rounding.
constexpr double kTie = 2 * kRoundingBounds.hitDistance * kRoundoff;

double signBy(std::uint64_t word, std::uint32_t number) {
  return (splitMix(word + number * kSplitMixStep) & 1) != 0 ? 1 : -1;
}

// The bound of the error of the distance of a triangle that the errors of its weights cause, by which the device rounds
// it up: docs/light-transport.md section 4.
double distanceError(const TriangleShape& triangle, const Ray& ray) {
  const dvec3 size = glm::abs(ray.direction);
  const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const auto sheared = [&](const dvec3& corner) {
    const dvec3 p = corner - ray.origin;
    const double depth = p[z] / ray.direction[z];
    return dvec3(p[x] - ray.direction[x] * depth, p[y] - ray.direction[y] * depth, depth);
  };
  const dvec3 a = sheared(triangle.corner), b = sheared(triangle.corner1), c = sheared(triangle.corner2);
  const double products = std::abs(c.x * b.y) + std::abs(a.x * c.y) + std::abs(b.x * a.y);
  const double weights = std::abs(c.x * b.y - c.y * b.x) + std::abs(a.x * c.y - a.y * c.x) +
                         std::abs(b.x * a.y - b.y * a.x);
  const double depth = std::abs(a.z - b.z) + std::abs(b.z - c.z);
  return weights > 0 ? kRoundingBounds.triangleWeights * kRoundoff * products * depth / weights : 0;
}

double texCoordError(const glm::vec3& row, const dvec2& scale) {
  const dvec3 terms = glm::abs(dvec3(row)) * dvec3(scale, 1);
  return kRoundingBounds.texCoord * kRoundoff * (1 + terms.x + terms.y + terms.z);
}

}  // namespace

// The points from which each kind of shape is computed.
struct RoundedTracing::ReachOfShape {
  const dvec3& eye;

  Reach operator()(const SphereShape& sphere) const {
    const dvec3 towards = eye - sphere.centre;
    const dvec3 outward = towards == dvec3(0) ? dvec3(0) : std::abs(sphere.radius) * normalize(towards);
    return {sphere.centre + outward, 0, kRoundingBounds.sphereTest};
  }

  Reach operator()(const TriangleShape& triangle) const {
    const dvec3 centre = (triangle.corner + triangle.corner1 + triangle.corner2) / 3.0;
    const double radius = std::max(
        {length(triangle.corner - centre), length(triangle.corner1 - centre), length(triangle.corner2 - centre)});
    return {centre, radius, kRoundingBounds.triangleTest};
  }

  Reach operator()(const BoxShape& box) const {
    return {(box.min + box.max) / 2.0, length(box.max - box.min) / 2, kRoundingBounds.boxTest};
  }

  Reach operator()(const ConeShape& cone) const { return {cone.base, cone.height, kRoundingBounds.coneTest}; }

  Reach operator()(const PlaneShape& plane) const { return {plane.point, 0, kRoundingBounds.planeTest}; }
};

RoundedTracing::RoundedTracing(const scene::Scene& scene, const Tracing& tracing, const dvec3& eye)
    : scene_(scene), tracing_(tracing), eye_(eye) {
  for (const Tracing::Item& item : tracing.items()) {
    reaches_.push_back(reachOfShape(item));
    hashes_.push_back(hashOfShape(item));
  }
}

RoundedTracing::Reach RoundedTracing::reachOfShape(const Tracing::Item& item) const {
  return std::visit(ReachOfShape{eye_}, item.shape);
}

std::uint32_t RoundedTracing::hashOfShape(const Tracing::Item& item) const {
  return scene::hashOf(shapeOf(scene_, scene_.primitives[item.primitive]));
}

std::optional<std::size_t> RoundedTracing::storedIndexOf(const Tracing::Item& item) const {
  const Tracing::Item* const first = tracing_.items().data();
  const std::less<> isBefore;
  const bool isStored = !isBefore(&item, first) && isBefore(&item, first + reaches_.size());
  return isStored ? std::optional(static_cast<std::size_t>(&item - first)) : std::nullopt;
}

dvec3 RoundedTracing::testedOrigin(const Tracing::Item& item, const dvec3& origin, const dvec3& signs) const {
  const std::optional<std::size_t> stored = storedIndexOf(item);
  const Reach reach = stored ? reaches_[*stored] : reachOfShape(item);
  return origin + reach.units * kRoundoff * (length(origin - reach.centre) + reach.radius) * signs;
}

double RoundedTracing::signOf(const Tracing::Item& item, std::uint64_t word) const {
  const std::optional<std::size_t> stored = storedIndexOf(item);
  return signBy(word, stored ? hashes_[*stored] : hashOfShape(item));
}

double RoundedTracing::roundedDistance(const Tracing::Item& item, double exact, std::uint64_t word) const {
  return exact * (1 + kTie / 2 * signOf(item, word));
}

double RoundedTracing::raisedBy(const Tracing::Item& item, const Ray& ray, std::uint64_t word) const {
  const auto* const triangle = std::get_if<TriangleShape>(&item.shape);
  if (triangle == nullptr || tracing_.mayCoincide(item)) return 0;
  return distanceError(*triangle, ray) * (1 + signOf(item, word));
}

bool RoundedTracing::passes(const Tracing::Item& item, const Ray& ray, std::uint64_t word) const {
  if (!item.transparent) return false;
  const MeshAttributes attributes = attributesAtHit(scene_, item.primitive, ray);
  const dvec2 signs(signBy(word, item.primitive), signBy(~word, item.primitive));
  const dvec2 st = roundedTexCoords(scene_.materials[item.material].opacity->texture, attributes, signs);
  return !isThere(scene_, item.primitive, ray, attributes, st);
}

Hit RoundedTracing::closest(Ray& ray, Counters& counters, const RayErrors& errors) const {
  Hit nearest;
  Tracing::Candidate best;
  dvec3 hitOrigin = ray.origin;
  Ray tested = ray;
  std::optional<Tracing::Item> made;
  const Tracing::Item* const origin = tracing_.itemOf(ray.originPrimitive, made);
  tracing_.visitItems(ray, best.distance, counters, [&](const Tracing::Item& item) {
    tested.origin = testedOrigin(item, ray.origin, errors.signs);
    const double exact = tracing_.distance(item, tested, origin);
    if (!(exact < best.distance * (1 + kTie))) return false;
    const double rounded = roundedDistance(item, exact, errors.word);
    const double compared = rounded + raisedBy(item, tested, errors.word);
    const Tracing::Candidate candidate = tracing_.candidate(item, tested, compared);
    if (!(candidate < best) || passes(item, tested, errors.word)) return false;
    best = candidate;
    nearest = {rounded, item.primitive};
    hitOrigin = tested.origin;
    return false;
  });
  ray.origin = hitOrigin;
  return nearest;
}

bool RoundedTracing::isOccluded(const Ray& ray, const RayEnd& end, Counters& counters, const RayErrors& errors) const {
  std::optional<Tracing::Item> madeOrigin, madeLight;
  const Tracing::Item* const origin = tracing_.itemOf(ray.originPrimitive, madeOrigin);
  const Tracing::Item* const light = tracing_.itemOf(end.light, madeLight);
  bool occluded = false;
  Ray tested = ray;
  const auto ofLight = [&] {
    Ray toLight = ray;
    toLight.origin = testedOrigin(*light, ray.origin, errors.signs);
    return roundedDistance(*light, tracing_.distance(*light, toLight, origin), errors.word);
  };
  tracing_.visitItems(ray, end.distance, counters, [&](const Tracing::Item& item) {
    if (item.primitive == end.light) return false;
    tested.origin = testedOrigin(item, ray.origin, errors.signs);
    const double t = tracing_.distance(item, tested, origin);
    if (t == kNoHit || passes(item, tested, errors.word)) return false;
    std::optional<bool> hides;
    if (light && item.emits)
      hides = tracing_.hidesEmitter(item, roundedDistance(item, t, errors.word), *light, ofLight());
    const double sign = signOf(item, errors.word);
    const double fraction = kLightMargin + sign * kRoundingBounds.lightDepth * kRoundoff;
    const double compared = t + raisedBy(item, tested, errors.word);
    occluded = hides.value_or(compared < end.distance * (1 - kTie / 2 * sign) &&
                              !tracing_.containsLight(item, tested, t, end, fraction));
    return occluded;
  });
  return occluded;
}

dvec2 roundedTexCoords(const std::optional<scene::TextureReference>& texture, const MeshAttributes& attributes,
                       const dvec2& signs) {
  if (!texture) return dvec2(0);
  const dvec2& scale = attributes.texCoordScale[texture->texCoordSet];
  const dvec2 errors(texCoordError(texture->rowS, scale), texCoordError(texture->rowT, scale));
  return textureCoordinates(*texture, attributes) + signs * errors;
}

}  // namespace candela::reference
