// Makes matrices of operations.
#include "host/formats/mitsuba/transform.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "host/base/finite.h"
#include "host/formats/mitsuba/attributes.h"

namespace candela::mitsuba {
namespace {

glm::dmat4 translation(const glm::dvec3& t) {
  glm::dmat4 m(1);
  m[3] = glm::dvec4(t, 1);
  return m;
}

/// Rotates by Rodrigues' formula. Multiples of 90 degrees are exact.
glm::dmat4 rotation(const glm::dvec3& axis, double degrees) {
  const double quarters = degrees / 90;
  double c = std::cos(degrees * std::numbers::pi / 180);
  double s = std::sin(degrees * std::numbers::pi / 180);
  if (quarters == std::round(quarters)) {
    const int quarter = static_cast<int>(std::fmod(quarters, 4) + 4) % 4;
    c = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
    s = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
  }
  const glm::dvec3 a = glm::normalize(axis);
  glm::dmat4 m(1);
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 e(0);
    e[column] = 1;
    m[column] = glm::dvec4(c * e + (1 - c) * a[column] * a + s * glm::cross(a, e), 0);
  }
  return m;
}

glm::dmat4 lookAt(const Element& element) {
  checkAttributes(element, {"origin", "target", "up"});
  const auto triple = [&](const char* name) { return tripleOf(requireAttribute(element, name), element.place); };
  const glm::dvec3 origin = triple("origin");
  const glm::dvec3 direction = triple("target") - origin;
  if (direction == glm::dvec3(0)) throw PlacedError{element.place, "origin and target of <lookat> are equal"};
  const glm::dvec3 forward = glm::normalize(direction);
  glm::dvec3 up = findAttribute(element, "up") ? triple("up") : glm::dvec3(0);
  if (up == glm::dvec3(0)) up = perpendicularTo(forward);
  const glm::dvec3 left = glm::cross(up, forward);
  if (!(glm::length(left) > 1e-9 * glm::length(up))) {
    throw PlacedError{element.place, "the vector \"up\" of <lookat> is parallel to its direction"};
  }
  glm::dmat4 m(1);
  m[0] = glm::dvec4(glm::normalize(left), 0);
  m[1] = glm::dvec4(glm::normalize(glm::cross(forward, left)), 0);
  m[2] = glm::dvec4(forward, 0);
  m[3] = glm::dvec4(origin, 1);
  return m;
}

glm::dmat4 matrix(const Element& element) {
  checkAttributes(element, {"value"});
  const std::vector<double> n = numbersOf(requireAttribute(element, "value"), element.place);
  if (n.size() != 9 && n.size() != 16) {
    throw PlacedError{element.place, fmt::format("<matrix> has {} numbers instead of 9 or 16", n.size())};
  }
  const std::size_t side = n.size() == 16 ? 4 : 3;
  glm::dmat4 m(1);
  for (std::size_t i = 0; i < n.size(); ++i) {
    m[static_cast<glm::length_t>(i % side)][static_cast<glm::length_t>(i / side)] = n[i];
  }
  return m;
}

glm::dmat4 madeOf(const Element& element) {
  if (element.name == "lookat" || element.name == "lookAt") return lookAt(element);
  if (element.name == "matrix") return matrix(element);
  if (element.name == "translate") {
    checkAttributes(element, {"x", "y", "z", "value"});
    return translation(vectorOf(element, 0));
  }
  if (element.name == "scale") {
    checkAttributes(element, {"x", "y", "z", "value"});
    glm::dmat4 m(1);
    const glm::dvec3 factors = vectorOf(element, 1);
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = factors[axis];
    return m;
  }
  if (element.name == "rotate") {
    checkAttributes(element, {"x", "y", "z", "value", "angle"});
    const glm::dvec3 axis = vectorOf(element, 0);
    if (!(glm::length(axis) > 0)) throw PlacedError{element.place, "the axis of <rotate> has no length"};
    return rotation(axis, numberOf(requireAttribute(element, "angle"), element.place));
  }
  throw PlacedError{element.place, fmt::format("<{}> is no operation of a transform", element.name)};
}

}  // namespace

glm::dmat4 operationOf(const Element& element) {
  const glm::dmat4 map = madeOf(element);
  for (int column = 0; column < 4; ++column) {
    const bool isFiniteColumn = isFinite(glm::dvec3(map[column])) && std::isfinite(map[column].w);
    if (!isFiniteColumn) throw PlacedError{element.place, "the transform has numbers that are not finite"};
  }
  return map;
}

// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 2017.
glm::dvec3 perpendicularTo(const glm::dvec3& n) {
  const double sign = std::copysign(1.0, n.z);
  const double a = -1 / (sign + n.z);
  return {sign * n.x * n.x * a + 1, sign * n.x * n.y * a, -sign * n.x};
}

bool isSimilarity(const glm::dmat4& map) {
  constexpr double kTolerance = 1e-3;
  const glm::dmat3 linear(map);
  const glm::dmat3 products = glm::transpose(linear) * linear;
  const double scale = (products[0][0] + products[1][1] + products[2][2]) / 3;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(products[i][j] - (i == j ? scale : 0)) <= kTolerance * scale)) return false;
    }
  }
  return scale > 0;
}

}  // namespace candela::mitsuba
