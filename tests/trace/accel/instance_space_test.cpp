// The padding of rays in the space of a mesh covers all errors between a hit in the scene and the mesh, and not twice
// as much; and boxes of instances contain their vertices.
#include "host/trace/accel/instance_space.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace candela::accel {
namespace {

using Real = long double;
using glm::dmat4;
using glm::dvec3;
using glm::vec3;

constexpr Real kUnit = 0x1p-24L;

class Numbers {
 public:
  double between(double low, double high) { return low + (high - low) * static_cast<double>(random_()) * 0x1p-32; }
  double magnitude(double low, double high) { return std::exp2(between(std::log2(low), std::log2(high))); }
  dvec3 direction() { return glm::normalize(dvec3(between(-1, 1), between(-1, 1), between(-1, 1)) + dvec3(1e-9)); }
  dvec3 inCube(double side) { return {between(-side, side), between(-side, side), between(-side, side)}; }

 private:
  std::mt19937 random_{3};
};

// Returns maps of all orientations, with scales from 1/1000 to 1000 whose axes differ up to twenty times.
dmat4 randomMap(Numbers& numbers) {
  const double scale = numbers.magnitude(1e-3, 1e3);
  dmat4 shear(1);
  shear[1][0] = numbers.between(-1, 1);
  const dvec3 sizes = scale * dvec3(1, numbers.magnitude(0.05, 1), -numbers.magnitude(0.05, 1));
  return glm::translate(dmat4(1), numbers.inCube(numbers.magnitude(0.01, 1e4))) *
         glm::rotate(dmat4(1), numbers.between(0, 6), numbers.direction()) * shear * glm::scale(dmat4(1), sizes);
}

Real largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns the row sums of the magnitudes of A times P, plus those of b.
Real placedReach(const scene::Placement& placement, double reach) {
  Real result = 0;
  for (const glm::vec4& row : placement.points) {
    const Real sum = std::abs(Real{row.x}) + std::abs(Real{row.y}) + std::abs(Real{row.z});
    result = std::max(result, sum * reach + std::abs(Real{row.w}));
  }
  return result;
}

// Returns the signs of the row of the inverse that has the largest sum: the direction in which an error matters most.
dvec3 worstDirection(const InstanceSpace& space) {
  double largestSum = 0;
  dvec3 signs(0);
  for (glm::length_t row = 0; row < 3; ++row) {
    const dvec3 entries(space.columns[0][row], space.columns[1][row], space.columns[2][row]);
    const double sum = std::abs(entries.x) + std::abs(entries.y) + std::abs(entries.z);
    if (sum <= largestSum) continue;
    largestSum = sum;
    signs = glm::sign(entries);
  }
  return signs;
}

vec3 applied(const InstanceSpace& space, const vec3& v) {
  return (space.columns[0] * v.x + space.columns[1] * v.y) + space.columns[2] * v.z;
}

TEST_CASE("the padding in a mesh covers a hit at the limit of its error, by less than twice") {
  Numbers numbers;
  Real largestRatio = 0;
  for (int i = 0; i < 100000; ++i) {
    const dmat4 map = randomMap(numbers);
    const auto placement = scene::placementOf(map);
    if (!placement) continue;
    const double side = numbers.magnitude(1e-3, 1e3);
    const Aabb box{vec3(static_cast<float>(-side)), vec3(static_cast<float>(side))};
    const InstanceSpace space = instanceSpace(*placement, box, 0);

    const dvec3 aim(map * glm::dvec4(numbers.inCube(0.9 * side), 1));
    const double distance = numbers.magnitude(0.01, 100) * static_cast<double>(placedReach(*placement, side));
    const vec3 origin(aim + distance * numbers.direction());
    const vec3 direction(glm::normalize(aim - dvec3(origin)));
    const auto t = static_cast<float>(glm::length(aim - dvec3(origin)));
    const dvec3 hit = dvec3(origin) + double{t} * dvec3(direction);  // exact but for the last bits of double precision

    const Real error = 18 * kUnit * (placedReach(*placement, side) + largest(dvec3(origin)));
    const dvec3 onTriangle = hit - static_cast<double>(error) * worstDirection(space);
    const vec3 vertex(dvec3(glm::inverse(map) * glm::dvec4(onTriangle, 1)));
    if (!(largest(dvec3(vertex)) <= side)) continue;
    REQUIRE(largest(dvec3(placedPoint(*placement, vertex)) - hit) <= 20 * kUnit / 18 / kUnit * error);

    const dvec3 inMesh = dvec3(applied(space, origin) + space.columns[3]) +
                         double{t} * dvec3(applied(space, direction));
    const Real padding = Real{space.padding} + Real{space.paddingPerOrigin} * largest(dvec3(origin));
    largestRatio = std::max(largestRatio, largest(inMesh - dvec3(vertex)) / padding);
  }
  CHECK(largestRatio <= 1);
  CHECK(largestRatio > 0.5);
}

TEST_CASE("the box of an instance contains its vertices, and is little larger") {
  Numbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const auto placement = scene::placementOf(randomMap(numbers));
    if (!placement) continue;
    const double side = numbers.magnitude(1e-3, 1e3);
    const Aabb box{vec3(static_cast<float>(-side)), vec3(static_cast<float>(side))};
    const Aabb placed = placedBounds(*placement, box);
    Aabb corners;
    for (int corner = 0; corner < 8; ++corner) {
      const vec3 point((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                       (corner & 4) ? box.max.z : box.min.z);
      corners.extend(placedPoint(*placement, point));
    }
    CHECK(placed.contains(corners));
    const Real slack = 80 * kUnit * placedReach(*placement, side);
    CHECK(largest(placed.extent() - corners.extent()) <= 2 * slack);
  }
}

}  // namespace
}  // namespace candela::accel
