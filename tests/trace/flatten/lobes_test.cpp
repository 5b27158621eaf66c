// The lobes of materials in the device's records.
#include "host/trace/flatten/lobes.h"

#include <catch2/catch.hpp>

using namespace candela;
using flatten::Lobes;
using flatten::lobesFor;
using render::Integrator;

TEST_CASE("records of materials have the weights, colours and parameters of the lobes that exist") {
  scene::Material material;
  material.diffuse = scene::DiffuseLobe{0.5, {1, 0.5f, 0}};
  material.glossy = scene::GlossyLobe{0.25, {0, 1, 0.5f}, 30};
  material.dielectric = scene::DielectricLobe{0.125, {0.5f, 0, 1}, 1.5f};
  const Lobes lobes = lobesFor(Integrator::path, material);
  CHECK(lobes.diffuse == 0.5);
  CHECK(lobes.glossy == 0.25);
  CHECK(lobes.dielectric == 0.125);
  CHECK_FALSE(lobes.mirror);
  CHECK(lobes.diffuseColour == glm::dvec3(1, 0.5, 0));
  CHECK(lobes.glossyColour == glm::dvec3(0, 1, 0.5));
  CHECK(lobes.specularColour == glm::dvec3(0.5, 0, 1));
  CHECK(lobes.exponent == 30);
  CHECK(lobes.ior == 1.5);
}

TEST_CASE("the record of a mirror has its colour and no weights, and that of a black material has neither") {
  scene::Material material;
  const Lobes black = lobesFor(Integrator::path, material);
  CHECK(black.diffuse + black.glossy + black.dielectric == 0);
  CHECK_FALSE(black.mirror);
  material.mirror = scene::MirrorLobe{{0.5f, 0.25f, 1}};
  const Lobes lobes = lobesFor(Integrator::path, material);
  CHECK(lobes.mirror);
  CHECK(lobes.diffuse + lobes.glossy + lobes.dielectric == 0);
  CHECK(lobes.specularColour == glm::dvec3(0.5, 0.25, 1));
}

TEST_CASE("the Whitted tracer has its own coefficients, whatever the lobes are") {
  scene::Material material;
  material.diffuse = scene::DiffuseLobe{};
  material.whitted = scene::WhittedMaterial{
      .kind = scene::WhittedKind::glass, .kd = 0.125f, .ks = 0.5f, .shine = 7, .ior = 1.25f};
  const Lobes glass = lobesFor(Integrator::whitted, material);
  CHECK(glass.diffuse == 0.125);
  CHECK(glass.glossy == 0.5);
  CHECK(glass.dielectric == 1);
  CHECK(glass.exponent == 7);
  CHECK(glass.ior == 1.25);
  CHECK_FALSE(glass.mirror);
  material.whitted->kind = scene::WhittedKind::mirror;
  CHECK(lobesFor(Integrator::whitted, material).mirror);
  CHECK(lobesFor(Integrator::whitted, material).dielectric == 0);
}

TEST_CASE("only the Whitted tracer has ambient light") {
  scene::Material material;
  material.whitted = scene::WhittedMaterial{.diffuse = {1, 0.5f, 0}, .ka = 0.5f};
  material.emission = {0, 0, 2};
  CHECK(flatten::ownRadiance(Integrator::path, material) == glm::dvec3(0, 0, 2));
  CHECK(flatten::ownRadiance(Integrator::whitted, material) == glm::dvec3(0.5, 0.25, 2));
}
