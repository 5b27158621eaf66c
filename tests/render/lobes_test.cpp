// The rules that turn an `f` line into lobes, and into what Whitted's tracer reads.
#include "host/flatten/lobes.h"

#include <catch2/catch.hpp>

using namespace candela;

namespace {

scene::Material material(float kd, float ks, float t, float ior) {
  scene::Material m;
  m.kd = kd;
  m.ks = ks;
  m.t = t;
  m.ior = ior;
  return m;
}

}  // namespace

TEST_CASE("Kd = 1 is diffuse whatever else is given") {
  CHECK(flatten::lobesOf(material(1, 1, 1, 1.5f)).diffuse == 1);
  CHECK(!flatten::lobesOf(material(1, 1, 1, 1.5f)).mirror);
}

TEST_CASE("Ks = 1 is a mirror") {
  CHECK(flatten::lobesOf(material(0.5f, 1, 0, 1)).mirror);
  CHECK(flatten::lobesOf(material(0.5f, 1, 0, 1)).diffuse == 0);
}

TEST_CASE("Kd = Ks = 0 is glass, and black where there is no index of refraction") {
  CHECK(flatten::lobesOf(material(0, 0, 0, 1.5f)).dielectric == 1);
  CHECK(flatten::lobesOf(material(0, 0, 0, 0)).dielectric == 0);
}

TEST_CASE("everything between is a mixture, scaled to 1 where it exceeds it") {
  const flatten::Lobes within = flatten::lobesOf(material(0.5f, 0.25f, 0.125f, 1.5f));
  CHECK(within.diffuse == 0.5);
  CHECK(within.glossy == 0.25);
  CHECK(within.dielectric == 0.125);
  const flatten::Lobes beyond = flatten::lobesOf(material(0.75f, 0.75f, 0.5f, 1.5f));
  CHECK(beyond.diffuse == 0.375);
  CHECK(beyond.glossy == 0.375);
  CHECK(beyond.dielectric == 0.25);
  CHECK(flatten::lobesOf(material(0.5f, 0.25f, 0.125f, 0)).dielectric == 0);
}

TEST_CASE("Whitted's tracer takes weights as they are, T = 0 with Ks as a mirror, T with an index as glass") {
  const flatten::Lobes opaque = flatten::whittedLobesOf(material(1, 0.75f, 0, 0));
  CHECK(opaque.diffuse == 1);
  CHECK(opaque.glossy == 0.75);
  CHECK(opaque.mirror);
  CHECK(opaque.dielectric == 0);
  const flatten::Lobes glass = flatten::whittedLobesOf(material(0.125f, 0.5f, 0.875f, 1.5f));
  CHECK(glass.dielectric == 1);
  CHECK(glass.glossy == 0.5);
  CHECK(!glass.mirror);
  const flatten::Lobes withoutIndex = flatten::whittedLobesOf(material(0, 0.5f, 1, 0));
  CHECK(withoutIndex.dielectric == 0);
  CHECK(!withoutIndex.mirror);
}

TEST_CASE("ambient light is Whitted's alone") {
  scene::Material m = material(1, 0, 0, 1);
  m.diffuse = {1, 0.5f, 0};
  m.ka = 0.5f;
  m.emission = {0, 0, 2};
  CHECK(flatten::ownRadiance(render::Integrator::path, m) == glm::dvec3(0, 0, 2));
  CHECK(flatten::ownRadiance(render::Integrator::whitted, m) == glm::dvec3(0.5, 0.25, 2));
}
