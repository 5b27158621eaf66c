// The table's weights and thresholds, and the sampling of spheres by solid angle and of triangles by area.
#include "host/reference/lights.h"

#include <algorithm>
#include <cmath>

#include "host/image/film.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kNoEntry = 0xffffffffu;
constexpr std::uint32_t kChoiceCount = 1u << 24;

// How a sphere is sampled from `point`: the cap of directions that meet it, or all directions.
struct SphereView {
  bool wholeSphere;
  double capHeight;

  SphereView(const SphereShape& sphere, const dvec3& point, bool leaving) {
    const dvec3 toCentre = sphere.centre - point;
    const double sinSquared = sphere.radius * sphere.radius / dot(toCentre, toCentre);
    wholeSphere = leaving || !(sinSquared < 1);
    capHeight = wholeSphere ? 2 : sinSquared / (1 + std::sqrt(1 - sinSquared));  // 1 - cos, without cancellation
  }
};

}  // namespace

LightTable::LightTable(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(scene), oneSided_(settings.oneSided), entryOfPrimitive_(scene.primitives.size(), kNoEntry) {
  collect(settings.nextEventEstimation);
  computeThresholds();
}

void LightTable::collect(bool withEmitters) {
  for (std::uint32_t i = 0; withEmitters && i < scene_.primitives.size(); ++i) {
    const scene::Primitive& primitive = scene_.primitives[i];
    const scene::Material& material = scene_.materials[primitive.material];
    if (!isEmissive(material)) continue;
    const double brightness = image::luminance(material.emission);
    if (primitive.kind == scene::PrimitiveKind::sphere) {
      const double radius = scene_.spheres[primitive.index].radius;
      entries_.push_back({Kind::sphere, i, 4 * kPi * radius * radius * brightness});
    } else if (primitive.kind == scene::PrimitiveKind::triangle) {
      const double area = length(TriangleShape(triangleOf(scene_, primitive)).areaNormal()) / 2;
      if (area == 0) continue;
      entries_.push_back({Kind::triangle, i, area * brightness});
    } else {
      continue;
    }
    entryOfPrimitive_[i] = static_cast<std::uint32_t>(entries_.size() - 1);
  }
  for (std::uint32_t i = 0; i < scene_.pointLights.size(); ++i) {
    entries_.push_back({Kind::point, i, image::luminance(scene_.pointLights[i].colour)});
  }
}

void LightTable::computeThresholds() {
  double emitterSum = 0;
  double pointSum = 0;
  for (const Entry& entry : entries_) (entry.kind == Kind::point ? pointSum : emitterSum) += entry.weight;
  const double share = emitterSum > 0 && pointSum > 0 ? 0.5 : 1;

  double running = 0;
  std::size_t last = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const double groupSum = entries_[i].kind == Kind::point ? pointSum : emitterSum;
    if (entries_[i].weight > 0) {
      running += share * entries_[i].weight / groupSum;
      last = i;
    }
    thresholds_.push_back(static_cast<std::uint32_t>(std::floor(running * kChoiceCount + 0.5)));
  }
  if (running > 0) std::fill(thresholds_.begin() + static_cast<std::ptrdiff_t>(last), thresholds_.end(), kChoiceCount);
}

double LightTable::probability(std::uint32_t entry) const {
  const std::uint32_t below = entry == 0 ? 0 : thresholds_[entry - 1];
  return static_cast<double>(thresholds_[entry] - below) / kChoiceCount;
}

LightChoice LightTable::choose(std::uint32_t word) const {
  const auto found = std::upper_bound(thresholds_.begin(), thresholds_.end(), word >> 8);
  const auto entry = static_cast<std::uint32_t>(found - thresholds_.begin());
  return {entry, probability(entry)};
}

const scene::Material& LightTable::materialOf(const Entry& entry) const {
  return scene_.materials[scene_.primitives[entry.index].material];
}

std::optional<LightSample> LightTable::sample(std::uint32_t entry, const Surface& surface, const dvec2& u) const {
  switch (entries_[entry].kind) {
    case Kind::sphere:
      return sampleSphere(entries_[entry], surface, u);
    case Kind::triangle:
      return sampleTriangleArea(entries_[entry], surface, u);
    case Kind::point:
      break;
  }
  return samplePoint(entries_[entry], surface);
}

std::optional<LightSample> LightTable::samplePoint(const Entry& entry, const Surface& surface) const {
  const scene::PointLight& light = scene_.pointLights[entry.index];
  const dvec3 toLight = dvec3(light.position) - surface.position;
  const double distance = length(toLight);
  if (distance == 0) return std::nullopt;
  return LightSample{toLight / distance, distance, kPi * dvec3(light.colour), std::nullopt, kNoPrimitive};
}

std::optional<LightSample> LightTable::sampleSphere(const Entry& entry, const Surface& surface, const dvec2& u) const {
  const SphereShape sphere(scene_.spheres[scene_.primitives[entry.index].index]);
  const bool leaving = surface.primitive == entry.index;
  const SphereView view(sphere, surface.position, leaving);
  const dvec3 local = sampleCap(u, view.capHeight);
  const dvec3 wi = view.wholeSphere ? local : Frame(normalize(sphere.centre - surface.position)).toWorld(local);
  const double distance = sphere.distance({surface.position, wi}, leaving);
  if (distance == kNoHit) return std::nullopt;
  return LightSample{wi, distance, materialOf(entry).emission, capPdf(view.capHeight), entry.index};
}

std::optional<LightSample> LightTable::sampleTriangleArea(const Entry& entry, const Surface& surface,
                                                          const dvec2& u) const {
  if (surface.primitive == entry.index) return std::nullopt;
  const TriangleShape triangle(triangleOf(scene_, scene_.primitives[entry.index]));
  const dvec2 b = sampleTriangle(u);
  const dvec3 toLight = triangle.corner + b.x * triangle.edge1 + b.y * triangle.edge2 - surface.position;
  const double distance = length(toLight);
  if (distance == 0) return std::nullopt;
  const dvec3 wi = toLight / distance;
  // Twice the area times the cosine; above 0 on the back.
  const double projected = dot(wi, triangle.areaNormal());
  if (projected == 0 || (oneSided_ && projected > 0)) return std::nullopt;
  const double pdf = 2 * distance * distance / std::abs(projected);
  return LightSample{wi, distance, materialOf(entry).emission, pdf, entry.index};
}

double LightTable::pdf(const Ray& ray, double distance, const Surface& surface) const {
  const std::uint32_t entry = entryOfPrimitive_[surface.primitive];
  if (entry == kNoEntry) return 0;
  const scene::Primitive& primitive = scene_.primitives[surface.primitive];
  if (entries_[entry].kind == Kind::sphere) {
    const SphereView view(SphereShape(scene_.spheres[primitive.index]), ray.origin, ray.leaving == surface.primitive);
    return probability(entry) * capPdf(view.capHeight);
  }
  const double projected = std::abs(dot(ray.direction, TriangleShape(triangleOf(scene_, primitive)).areaNormal()));
  return probability(entry) * 2 * distance * distance / projected;
}

}  // namespace candela::reference
