// Measures a scene and its environment.
#include "host/trace/reference/light_flux.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/image/film.h"
#include "host/scene/placed_bounds.h"
#include "host/scene/shape.h"

namespace candela::reference {
namespace {

using glm::dvec3;

/// A ball of which the ends of a primitive's box are made.
struct Ball {
  dvec3 centre;
  double radius;
};

using Balls = std::vector<Ball>;

Balls ballsOf(const scene::Sphere& s) { return {{dvec3(s.centre), std::abs(double{s.radius})}}; }

Balls ballsOf(const scene::Triangle& t) { return {{dvec3(t.p[0]), 0}, {dvec3(t.p[1]), 0}, {dvec3(t.p[2]), 0}}; }

Balls ballsOf(const scene::Box& box) { return {{dvec3(box.min), 0}, {dvec3(box.max), 0}}; }

Balls ballsOf(const scene::Cone& cone) {
  return {{dvec3(cone.base), cone.baseRadius}, {dvec3(cone.apex), cone.apexRadius}};
}

Balls ballsOf(const scene::Plane&) { return {}; }

}  // namespace

double squaredRadius(const scene::Scene& scene) {
  bool isEmpty = true;
  dvec3 low(0), high(0);
  const auto extend = [&](const Ball& ball) {
    low = isEmpty ? ball.centre - ball.radius : glm::min(low, ball.centre - ball.radius);
    high = isEmpty ? ball.centre + ball.radius : glm::max(high, ball.centre + ball.radius);
    isEmpty = false;
  };
  scene::PlacedBounds placed(scene);
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    if (run.start.isPlaced()) {
      const scene::Bounds box = placed.of(run);
      for (const glm::vec3& end : {box.min, box.max}) extend({dvec3(end), 0});
      continue;
    }
    for (std::uint32_t i = 0; i < scene.primitives.countOf(run); ++i) {
      const scene::Shape shape = shapeOf(scene, run.at(run.first + i));
      for (const Ball& ball : std::visit([](const auto& of) { return ballsOf(of); }, shape)) extend(ball);
    }
  }
  return glm::dot(high - low, high - low) / 4;
}

double meanLuminance(const scene::Environment& environment) {
  // The solid angle between two circles of latitude is in proportion to the difference of their heights.
  const double pole = environment.offsetOfPoles();
  const auto heightOf = [&](double t) {
    return std::cos(std::numbers::pi * std::clamp((t - pole) / (environment.height - 2 * pole), 0.0, 1.0));
  };
  double sum = 0;
  for (std::size_t row = 0; row < environment.height; ++row) {
    const auto top = static_cast<double>(row);
    const double fraction = (heightOf(top) - heightOf(top + 1)) / 2;
    for (std::size_t column = 0; column < environment.width; ++column) {
      sum += fraction * image::luminance(dvec3(environment.texels[row * environment.width + column]));
    }
  }
  return sum / environment.width;
}

}  // namespace candela::reference
