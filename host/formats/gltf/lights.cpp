// Reads lights.
#include "host/formats/gltf/lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/quote.h"

namespace candela::gltf {
namespace {

using scene::PunctualLight;

constexpr double kAngleTolerance = 1e-6;  // radians
constexpr double kMinAngle = 1e-6;        // of the outer cone, in radians; single precision renders no narrower one

PunctualLight::Kind kindOf(const Value& type) {
  if (type.text() == "point") return PunctualLight::Kind::point;
  if (type.text() == "spot") return PunctualLight::Kind::spot;
  if (type.text() != "directional") type.fail(scene::quote(type.text()) + " is not point, spot or directional");
  return PunctualLight::Kind::directional;
}

/// Returns 1 - cos of an angle, without cancellation.
float versine(double angle) {
  const double sine = std::sin(angle / 2);
  return static_cast<float>(2 * sine * sine);
}

/// Files store pi/2 in single precision, which exceeds pi/2, and equal angles for a cone with a hard edge.
void readCone(const Value& light, PunctualLight& result, scene::DiagnosticLog& log) {
  constexpr double kMax = std::numbers::pi / 2;
  const Value spot = light.require("spot");
  const double inner = spot.numberOr("innerConeAngle", 0);
  const double outer = spot.numberOr("outerConeAngle", std::numbers::pi / 4);
  if (!(inner >= 0 && outer >= kMinAngle && outer <= kMax + kAngleTolerance)) {
    spot.fail("the angles of the cones are not inner >= 0 and 1e-6 <= outer <= pi/2");
  }
  if (inner >= outer) {
    log.warn("cone", {}, spot.pointer() + ": the inner cone is not inside the outer one, so that its edge is hard");
  }
  result.versineInner = versine(std::min(inner, outer));
  result.versineOuter = versine(std::min(outer, kMax));
  if (result.versineInner >= result.versineOuter) result.versineInner = std::nextafter(result.versineOuter, 0.0f);
}

}  // namespace

PunctualLight punctualLight(const Value& light, const glm::dmat4& world, scene::DiagnosticLog& log) {
  PunctualLight result;
  result.kind = kindOf(light.require("type"));
  const auto colour = light.vectorOr("color", glm::dvec3(1));
  const double intensity = light.numberOr("intensity", 1);
  if (glm::any(glm::lessThan(colour, glm::dvec3(0))) || intensity < 0) light.fail("a colour or intensity is negative");
  result.intensity = glm::vec3(intensity * colour);
  result.position = glm::vec3(glm::dvec3(world[3]));
  const glm::dvec3 axis(world[2]);
  const double length = glm::length(axis);
  if (length > 0 && std::isfinite(length)) result.direction = glm::vec3(-axis / length);
  if (result.kind == PunctualLight::Kind::spot) readCone(light, result, log);
  return result;
}

}  // namespace candela::gltf
