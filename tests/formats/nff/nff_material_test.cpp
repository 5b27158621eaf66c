// The rules that convert an `f` line to lobes, and to the coefficients of Whitted's integrator.
#include "host/formats/nff/nff_material.h"

#include <catch2/catch.hpp>

namespace candela::scene {
namespace {

// Returns the weights of a material's lobes; 0 for lobes that it lacks.
double diffuseOf(const Material& m) { return m.diffuse ? m.diffuse->weight : 0; }
double glossyOf(const Material& m) { return m.glossy ? m.glossy->weight : 0; }
double dielectricOf(const Material& m) { return m.dielectric ? m.dielectric->weight : 0; }

Material material(float kd, float ks, float t, float ior) { return fromNff({.kd = kd, .ks = ks, .t = t, .ior = ior}); }

}  // namespace

TEST_CASE("Kd = 1 is diffuse whatever the other numbers are") {
  const Material m = material(1, 1, 1, 1.5f);
  CHECK(kindOf(m) == MaterialKind::diffuse);
  CHECK(diffuseOf(m) == 1);
  CHECK_FALSE(m.opaque);
}

TEST_CASE("Ks = 1 is a mirror") {
  const Material m = material(0.5f, 1, 0, 1);
  CHECK(kindOf(m) == MaterialKind::mirror);
  CHECK_FALSE(m.diffuse);
  CHECK(m.opaque);
}

TEST_CASE("Kd = Ks = 0 is glass for any T, and black without an index of refraction") {
  CHECK(kindOf(material(0, 0, 0, 1.5f)) == MaterialKind::dielectric);
  CHECK(dielectricOf(material(0, 0, 0.25f, 1.5f)) == 1);
  CHECK(kindOf(material(0, 0, 0, 0)) == MaterialKind::black);
}

TEST_CASE("all other materials are mixtures, scaled to 1 if their weights exceed it") {
  const Material within = material(0.5f, 0.25f, 0.125f, 1.5f);
  CHECK(kindOf(within) == MaterialKind::mixture);
  CHECK(diffuseOf(within) == 0.5);
  CHECK(glossyOf(within) == 0.25);
  CHECK(dielectricOf(within) == 0.125);
  const Material beyond = material(0.75f, 0.75f, 0.5f, 1.5f);
  CHECK(diffuseOf(beyond) == 0.375);
  CHECK(glossyOf(beyond) == 0.375);
  CHECK(dielectricOf(beyond) == 0.25);
  const Material withoutIndex = material(0.75f, 0.75f, 0.5f, 0);  // T is dropped after the scaling
  CHECK(diffuseOf(withoutIndex) == 0.375);
  CHECK_FALSE(withoutIndex.dielectric);
}

TEST_CASE("a mixture of one lobe has the name of the lobe") {
  CHECK(kindOf(material(0.5f, 0, 0, 1)) == MaterialKind::diffuse);
  CHECK(kindOf(material(0, 0.5f, 0, 1)) == MaterialKind::glossy);
}

TEST_CASE("every lobe has its colour and its parameter") {
  const glm::vec3 diffuse(0.1f, 0.2f, 0.3f), specular(0.4f, 0.5f, 0.6f);
  const Material m = fromNff(
      {.diffuse = diffuse, .kd = 0.25f, .specular = specular, .ks = 0.25f, .shine = 30, .t = 0.25f, .ior = 1.5f});
  CHECK(m.diffuse->colour == diffuse);
  CHECK(m.glossy->colour == specular);
  CHECK(m.glossy->exponent == 30);
  CHECK(m.dielectric->colour == diffuse);
  CHECK(m.dielectric->ior == 1.5f);
  CHECK(fromNff({.diffuse = diffuse, .kd = 0, .specular = specular, .ks = 1}).mirror->colour == diffuse);
}

TEST_CASE("the Whitted tracer uses Kd and Ks unchanged, T = 0 with Ks as a mirror, and T with an index as glass") {
  const WhittedMaterial opaque = material(1, 0.75f, 0, 0).whitted.value();
  CHECK(opaque.kd == 1);
  CHECK(opaque.ks == 0.75f);
  CHECK(opaque.kind == WhittedKind::mirror);
  const WhittedMaterial glass = material(0.125f, 0.5f, 0.875f, 1.5f).whitted.value();
  CHECK(glass.kind == WhittedKind::glass);
  CHECK(glass.ks == 0.5f);
  CHECK(glass.ior == 1.5f);
  CHECK(material(0, 0.5f, 1, 0).whitted->kind == WhittedKind::opaque);
  CHECK(material(0.5f, 0, 0, 1).whitted->kind == WhittedKind::opaque);
}

}  // namespace candela::scene
