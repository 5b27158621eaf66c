// Converts colours between sets of primaries.
#include "host/image/chromaticities.h"

#include <algorithm>
#include <cmath>

namespace candela::image {
namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

constexpr double kEqualChromaticities = 1e-3;

dvec3 xyzOf(const dvec2& xy) { return {xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y}; }

bool hasFiniteElements(const dmat3& m) {
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

dmat3 diagonal(const dvec3& factors) {
  return {dvec3(factors.x, 0, 0), dvec3(0, factors.y, 0), dvec3(0, 0, factors.z)};
}

/// Returns the matrix from RGB to XYZ, in which white has Y = 1.
dmat3 toXyz(const Chromaticities& space) {
  const dmat3 primaries(xyzOf(space.red), xyzOf(space.green), xyzOf(space.blue));
  return primaries * diagonal(glm::inverse(primaries) * xyzOf(space.white));
}

dmat3 adaptation(const dvec2& from, const dvec2& to) {
  const dmat3 cones(dvec3(0.8951, -0.7502, 0.0389), dvec3(0.2664, 1.7135, -0.0685), dvec3(-0.1614, 0.0367, 1.0296));
  return glm::inverse(cones) * diagonal((cones * xyzOf(to)) / (cones * xyzOf(from))) * cones;
}

bool areNear(const dvec2& a, const dvec2& b) {
  return glm::all(glm::lessThanEqual(glm::abs(a - b), dvec2(kEqualChromaticities)));
}

bool isRec709(const Chromaticities& space) {
  constexpr Chromaticities kRec709;
  return areNear(space.red, kRec709.red) && areNear(space.green, kRec709.green) && areNear(space.blue, kRec709.blue) &&
         areNear(space.white, kRec709.white);
}

}  // namespace

std::optional<dmat3> toRec709(const Chromaticities& space) {
  constexpr Chromaticities kRec709;
  constexpr double kMaxFactor = 1e3;
  const dmat3 matrix = glm::inverse(toXyz(kRec709)) * adaptation(space.white, kRec709.white) * toXyz(space);
  if (!hasFiniteElements(matrix)) return std::nullopt;
  for (int column = 0; column < 3; ++column) {
    const dvec3 size = glm::abs(matrix[column]);
    if (std::max({size.x, size.y, size.z}) > kMaxFactor) return std::nullopt;  // primaries on one line, nearly
  }
  return matrix;
}

void convertToRec709(const Chromaticities& space, Image& image) {
  if (isRec709(space)) return;
  const std::optional<dmat3> matrix = toRec709(space);
  if (!matrix) {
    image.warnings.emplace_back("its chromaticities are ignored, since they do not describe a colour space");
    return;
  }
  for (glm::vec3& pixel : image.rgb) pixel = glm::vec3(*matrix * dvec3(pixel));
}

}  // namespace candela::image
