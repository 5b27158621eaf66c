// Computes the mappings.
#include "host/trace/reference/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::reference {

dvec2 sampleDisc(const dvec2& u) {
  const double a = 2 * u.x - 1;
  const double b = 2 * u.y - 1;
  if (std::abs(a) > std::abs(b)) {
    const double phi = kPi / 4 * (b / a);
    return {a * std::cos(phi), a * std::sin(phi)};
  }
  if (b == 0) return {0, 0};
  const double phi = kPi / 2 - kPi / 4 * (a / b);
  return {b * std::cos(phi), b * std::sin(phi)};
}

dvec3 sampleCosineHemisphere(const dvec2& u) {
  const dvec2 p = sampleDisc(u);
  return {p, std::sqrt(std::max(0.0, 1 - dot(p, p)))};
}

dvec3 sampleCap(const dvec2& u, double height) {
  const dvec2 p = sampleDisc(u);
  const double q = dot(p, p);
  return {p * std::sqrt(height * (2 - q * height)), 1 - q * height};
}

dvec2 sampleTriangle(const dvec2& u) {
  const double s = std::sqrt(u.x);
  return {s * (1 - u.y), s * u.y};
}

double sampleTent(double u) { return u < 0.5 ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

// The integral of the density from x to 4 is convex in x >= 0, where the density falls. Newton's method therefore
// approaches the x with a given integral from 0 on without passing it.
double sampleGaussian(double u) {
  constexpr double kEnd = 4, kSmallStep = 1e-12;
  static const double edge = std::exp(-kEnd * kEnd / 2);
  static const double beyondEnd = std::erfc(kEnd / std::numbers::sqrt2);
  const auto integralFrom = [](double x) {
    return std::sqrt(kPi / 2) * (std::erfc(x / std::numbers::sqrt2) - beyondEnd) - (kEnd - x) * edge;
  };
  const double goal = 2 * integralFrom(0) * std::min(u, 1 - u);
  if (goal == 0) return u < 0.5 ? -kEnd : kEnd;
  double x = 0;
  for (double step = kEnd; step > kSmallStep; x += step) {
    step = (integralFrom(x) - goal) / (std::exp(-x * x / 2) - edge);
  }
  return u < 0.5 ? -x : x;
}

Frame::Frame(const dvec3& n) : normal(n) {
  const double s = n.z > -0.62 ? 1.0 : -1.0;
  const double a = -1 / (s + n.z);
  const double b = n.x * n.y * a;
  tangent = {1 + s * n.x * n.x * a, s * b, -s * n.x};
  bitangent = {b, s + n.y * n.y * a, -n.y};
}

Frame::Frame(const dvec3& unitNormal, const dvec3& along) : Frame(unitNormal) {
  const dvec3 across = cross(unitNormal, along);
  const double sine = length(across);
  if (sine < 1e-6) return;
  bitangent = across / sine;
  tangent = cross(bitangent, unitNormal);
}

}  // namespace candela::reference
