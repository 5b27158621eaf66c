// Estimates the light that a scene receives from each group of lights.
#include "host/trace/flatten/light_groups.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/image/film.h"
#include "host/scene/environment/weights.h"
#include "host/scene/placed_bounds.h"
#include "host/scene/shape.h"

namespace candela::flatten {
namespace {

using glm::dvec3;

constexpr double kMinProbability = 0.2;

struct Extent {
  dvec3 low{std::numeric_limits<double>::infinity()};
  dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const dvec3& point, double radius) {
    low = glm::min(low, point - radius);
    high = glm::max(high, point + radius);
  }
};

void add(const scene::Sphere& sphere, Extent& extent) {
  extent.add(dvec3(sphere.centre), std::abs(double{sphere.radius}));
}

void add(const scene::Triangle& triangle, Extent& extent) {
  for (const glm::vec3& corner : triangle.p) extent.add(dvec3(corner), 0);
}

void add(const scene::Bounds& box, Extent& extent) {
  extent.add(dvec3(box.min), 0);
  extent.add(dvec3(box.max), 0);
}

void add(const scene::Box& box, Extent& extent) {
  extent.add(dvec3(box.min), 0);
  extent.add(dvec3(box.max), 0);
}

void add(const scene::Cone& cone, Extent& extent) {
  extent.add(dvec3(cone.base), cone.baseRadius);
  extent.add(dvec3(cone.apex), cone.apexRadius);
}

// Planes are infinite.
void add(const scene::Plane&, Extent&) {}

// The square of half the diagonal of the box around everything that is bounded; 0 if nothing is.
double squaredRadius(const scene::Scene& scene) {
  Extent extent;
  scene::PlacedBounds placed(scene);
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    if (run.start.isPlaced()) {
      add(placed.of(run), extent);
      continue;
    }
    const std::uint32_t end = run.first + scene.primitives.countOf(run);
    for (std::uint32_t i = run.first; i < end; ++i) {
      std::visit([&](const auto& shape) { add(shape, extent); }, shapeOf(scene, run.at(i)));
    }
  }
  const dvec3 diagonal = extent.high - extent.low;
  return diagonal.x >= 0 ? glm::dot(diagonal, diagonal) / 4 : 0;
}

double meanLuminance(const scene::Environment& environment) {
  double sum = 0, solidAngle = 0;
  for (std::uint32_t row = 0; row < environment.height; ++row) {
    const double texel = environment::solidAngleOfRow(environment, row);
    double luminance = 0;
    for (std::uint32_t column = 0; column < environment.width; ++column) {
      luminance += image::luminance(dvec3(environment.texels[std::size_t{row} * environment.width + column]));
    }
    sum += texel * luminance;
    solidAngle += texel * environment.width;
  }
  return sum / solidAngle;
}

// In units of pi.
double fluxOf(const scene::Scene& scene, const LightEntry& entry, double squared) {
  if (entry.isPoint()) return entry.power * std::numbers::pi * squared;
  if (entry.isEnvironment()) return entry.power > 0 ? 4 * squared * meanLuminance(*scene.environment) : 0;
  return entry.power;
}

}  // namespace

std::size_t groupOf(LightKind kind, render::LightSelection selection) {
  if (kind == LightKind::environment) return 2;
  const bool hasPlace = kind == LightKind::punctual || kind == LightKind::spot;
  return kind < LightKind::point || (hasPlace && selection == render::LightSelection::tree) ? 0 : 1;
}

GroupValues groupProbabilities(const scene::Scene& scene, std::span<const LightEntry> entries,
                               render::LightSelection selection, const GroupValues& weights) {
  const auto count = static_cast<double>(std::ranges::count_if(weights, [](double weight) { return weight > 0; }));
  GroupValues flux = weights;
  if (count > 1) {
    const double squared = squaredRadius(scene);
    flux = {};
    for (const LightEntry& entry : entries) flux[groupOf(entry.kind, selection)] += fluxOf(scene, entry, squared);
  }
  const double sum = flux[0] + flux[1] + flux[2];
  GroupValues probabilities{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    probabilities[i] = count == 1 || !(sum > 0) ? 1 / count
                                                : kMinProbability + (1 - kMinProbability * count) * flux[i] / sum;
  }
  return probabilities;
}

}  // namespace candela::flatten
