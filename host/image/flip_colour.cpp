// Colour differences of FLIP (section 4.1 of the paper).
#include "host/image/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace candela::image::flip {
namespace {

using glm::dmat3;
using glm::dvec3;

/// Exponent of the HyAB distance, and the parameters of the error redistribution.
constexpr double kQc = 0.7;
constexpr double kPc = 0.4;
constexpr double kPt = 0.95;

/// Matrix from linear Rec. 709 to CIE XYZ, from the primaries and D65 (0.3127, 0.3290) as exact fractions; by columns.
dmat3 xyzMatrix() {
  return {10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382,  //
          8788810.0 / 24577794,  8788810.0 / 12288897, 8788810.0 / 73733382,  //
          4435075.0 / 24577794,  887015.0 / 12288897,  70074185.0 / 73733382};
}

/// Returns XYZ relative to white, which becomes (1, 1, 1).
dmat3 relativeXyzMatrix() {
  const dmat3 xyz = xyzMatrix();
  const dvec3 white = xyz * dvec3(1);
  return {xyz[0] / white, xyz[1] / white, xyz[2] / white};
}

const dmat3 kToRelativeXyz = relativeXyzMatrix();
const dmat3 kFromRelativeXyz = glm::inverse(relativeXyzMatrix());

double labCurve(double t) {
  constexpr double kDelta = 6.0 / 29;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

/// Maximum distance: HyAB of green and blue to the power of qc.
double largestDistance() {
  static const double distance = std::pow(hyab(toHuntLab({0, 1, 0}), toHuntLab({0, 0, 1})), kQc);
  return distance;
}

}  // namespace

dvec3 toOpponent(const dvec3& linear) {
  const dvec3 xyz = kToRelativeXyz * linear;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

dvec3 fromOpponent(const dvec3& opponent) {
  const double y = (opponent.x + 16) / 116;
  return kFromRelativeXyz * dvec3(y + opponent.y / 500, y, y - opponent.z / 200);
}

dvec3 toHuntLab(const dvec3& linear) {
  const dvec3 xyz = kToRelativeXyz * linear;
  const dvec3 f(labCurve(xyz.x), labCurve(xyz.y), labCurve(xyz.z));
  const double lightness = 116 * f.y - 16;
  return {lightness, 0.01 * lightness * 500 * (f.x - f.y), 0.01 * lightness * 200 * (f.y - f.z)};
}

double hyab(const dvec3& a, const dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

double colourError(const dvec3& a, const dvec3& b) {
  const double largest = largestDistance();
  const double bend = kPc * largest;
  const double distance = std::min(std::pow(hyab(a, b), kQc), largest);
  return distance < bend ? kPt / bend * distance : kPt + (distance - bend) / (largest - bend) * (1 - kPt);
}

}  // namespace candela::image::flip
