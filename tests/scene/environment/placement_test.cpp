// The orientation of maps: docs/gltf.md, "Environment light".
#include "host/scene/environment/placement.h"

#include <catch2/catch.hpp>

using namespace candela;
using namespace candela::environment;
using glm::dvec3;
using glm::vec3;

namespace {

// Converts a direction of the map to one of the scene.
dvec3 inScene(const scene::Environment& environment, const dvec3& d) {
  return d.x * dvec3(environment.axes[0]) + d.y * dvec3(environment.axes[1]) + d.z * dvec3(environment.axes[2]);
}

scene::Environment placed(const vec3& up, double degrees) {
  scene::Environment environment;
  place(environment, up, degrees);
  return environment;
}

void checkClose(const dvec3& a, const dvec3& b) { CHECK(length(a - b) < 1e-6); }

}  // namespace

TEST_CASE("the centre of a map is +x, a quarter to its right is +z, the edges are -x, and the top is +y") {
  checkClose(directionOf(32, 16, 64, 32), {1, 0, 0});
  checkClose(directionOf(48, 16, 64, 32), {0, 0, 1});
  checkClose(directionOf(16, 16, 64, 32), {0, 0, -1});
  checkClose(directionOf(0, 16, 64, 32), {-1, 0, 0});
  checkClose(directionOf(64, 16, 64, 32), {-1, 0, 0});
  checkClose(directionOf(7, 0, 64, 32), {0, 1, 0});
  checkClose(directionOf(7, 32, 64, 32), {0, -1, 0});
  checkClose(directionOf(32, 8, 64, 32), {std::sqrt(0.5), std::sqrt(0.5), 0});
}

TEST_CASE("a rotation by 90 degrees moves the direction +x to -z") {
  const scene::Environment turned = placed({0, 1, 0}, 90);
  checkClose(inScene(turned, {1, 0, 0}), {0, 0, -1});
  checkClose(inScene(turned, {0, 0, 1}), {1, 0, 0});
  checkClose(inScene(turned, {0, 1, 0}), {0, 1, 0});
  checkClose(inScene(placed({0, 1, 0}, 30), {1, 0, 0}), {std::sqrt(0.75), 0, -0.5});
}

TEST_CASE("where z points up, the axes of a map are x, z and -y of the scene") {
  const scene::Environment zUp = placed({0, 0, 1}, 0);
  checkClose(inScene(zUp, {1, 0, 0}), {1, 0, 0});
  checkClose(inScene(zUp, {0, 1, 0}), {0, 0, 1});
  checkClose(inScene(zUp, {0, 0, 1}), {0, -1, 0});
}

TEST_CASE("the axes of a map are right-handed and orthonormal, whatever axis points up") {
  for (const vec3& up : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
    for (const double degrees : {0.0, 33.0, -200.0}) {
      const scene::Environment environment = placed(up, degrees);
      CAPTURE(up.x, up.y, up.z, degrees);
      CHECK(environment.axes[1] == up);
      checkClose(cross(dvec3(environment.axes[0]), dvec3(environment.axes[1])), dvec3(environment.axes[2]));
      CHECK(length(environment.axes[0]) == Approx(1));
    }
  }
}
