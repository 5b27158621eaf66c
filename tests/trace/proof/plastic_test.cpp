// Plastic: docs/light-transport.md section 5.14.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_density.h"
#include "tests/trace/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using enum scene::Interface;

namespace {

constexpr float kIor = 1.49f / 1.000277f;  // polypropylene in air

scene::Material plastic(scene::Interface boundary, double alpha, double base, double specular,
                        bool isNonlinear = false) {
  const auto roughness = static_cast<float>(std::sqrt(alpha));
  return materialOf({.baseColour = glm::vec3(static_cast<float>(base)),
                     .specularColour = glm::vec3(static_cast<float>(specular)),
                     .roughness = roughness,
                     .ior = kIor,
                     .plastic = scene::makePlastic(boundary, roughness, kIor, isNonlinear)});
}

/// A pair of directions, colours, and f by tests/trace/proof/plastic_model.py.
struct PlasticValue {
  double cosO, cosI, turn, base, specular;
  bool isNonlinear;
  double f;
};
struct PlasticModel {
  scene::Interface boundary;
  double alpha;
  std::vector<PlasticValue> values;
};
const std::vector<PlasticModel> kModel{{smooth,
                                        0,
                                        {{0.9, 0.8, 0.45, 0.5, 1, false, 0.161087987},
                                         {0.6, 0.7, 0.5, 0.5, 1, true, 0.0906531202},
                                         {0.3, 0.35, 0.52, 0.2, 0.7, false, 0.0465732141},
                                         {0.12, 0.5, 0.3, 0.8, 1, true, 0.0968655232}}},
                                       {ggx,
                                        0.1,
                                        {{0.9, 0.8, 0.45, 0.5, 1, false, 0.202695657},
                                         {0.6, 0.7, 0.5, 0.5, 1, true, 0.592873822},
                                         {0.3, 0.35, 0.52, 0.2, 0.7, false, 0.542661678},
                                         {0.12, 0.5, 0.3, 0.8, 1, true, 0.11789009}}},
                                       {beckmann,
                                        0.1,
                                        {{0.9, 0.8, 0.45, 0.5, 1, false, 0.230158627},
                                         {0.6, 0.7, 0.5, 0.5, 1, true, 0.768684463},
                                         {0.3, 0.35, 0.52, 0.2, 0.7, false, 0.380626157},
                                         {0.12, 0.5, 0.3, 0.8, 1, true, 0.107940022}}},
                                       {ggx,
                                        0.3,
                                        {{0.9, 0.8, 0.45, 0.5, 1, false, 0.143256488},
                                         {0.6, 0.7, 0.5, 0.5, 1, true, 0.176194078},
                                         {0.3, 0.35, 0.52, 0.2, 0.7, false, 0.468544601},
                                         {0.12, 0.5, 0.3, 0.8, 1, true, 0.115949645}}},
                                       {beckmann,
                                        0.5,
                                        {{0.9, 0.8, 0.45, 0.5, 1, false, 0.131905438},
                                         {0.6, 0.7, 0.5, 0.5, 1, true, 0.120146008},
                                         {0.3, 0.35, 0.52, 0.2, 0.7, false, 0.33295415},
                                         {0.12, 0.5, 0.3, 0.8, 1, true, 0.129944481}}}};

const std::vector<dvec3> kPlasticViews{directionAt(0.99, 0.05), directionAt(0.6, 0.42), directionAt(0.15, 0.7)};

}  // namespace

TEST_CASE("plastic has the values of an independent computation from Mitsuba's formulas") {
  for (const PlasticModel& model : kModel) {
    std::vector<scene::Material> materials;
    for (const PlasticValue& v : model.values) {
      materials.push_back(plastic(model.boundary, model.alpha, v.base, v.specular, v.isNonlinear));
    }
    const MaterialLeaves leaves(materials);
    for (std::uint32_t i = 0; i < model.values.size(); ++i) {
      const PlasticValue& v = model.values[i];
      const DirectionPair pair{i, directionAt(v.cosO, 0.1), directionAt(v.cosI, 0.1 + v.turn)};
      CAPTURE(static_cast<int>(model.boundary), model.alpha, v.cosO, v.cosI);
      CHECK(leaves.evaluate(std::vector{pair}).front().f.x == Approx(v.f).epsilon(1e-4));
    }
  }
}

TEST_CASE("plastic is sampled with the stated density, also below a coat and a sheen", "[swiftshader-slow]") {
  std::vector<scene::Material> materials;
  for (const scene::Interface boundary : {smooth, ggx, beckmann}) {
    for (const float roughness : kRoughnesses) {
      if (boundary == smooth && roughness > kRoughnesses.front()) continue;
      materials.push_back(plastic(boundary, double{roughness} * roughness, 0.7, 0.9));
      materials.back().surface->baseColour = {0.8f, 0.5f, 0.1f};
    }
  }
  materials.push_back(plastic(beckmann, 0.3, 0.7, 1, true));
  materials.back().surface->coatWeight = 0.8f;
  materials.back().surface->coatRoughness = 0.5f;
  materials.back().surface->sheenColour = {0.2f, 0.5f, 0.9f};
  materials.back().surface->sheenRoughness = 0.6f;
  const MaterialLeaves leaves(materials);
  const SurfaceNumbers numbers;
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const dvec3& wo : kPlasticViews) {
      CAPTURE(i, materials[i].surface->roughness, wo.z);
      checkSurface(leaves, {i, *materials[i].surface, wo}, numbers);
    }
  }
}

TEST_CASE("plastic is reciprocal") {
  const MaterialLeaves leaves({plastic(smooth, 0, 0.7, 0.9), plastic(ggx, 0.2, 0.7, 0.9),
                               plastic(beckmann, 0.4, 0.7, 0.9), plastic(beckmann, 0.4, 0.7, 0.9, true)});
  const std::vector<glm::vec3> a = randomNumbers(2000, 331), b = randomNumbers(2000, 332);
  for (std::uint32_t i = 0; i < 4; ++i) {
    std::vector<DirectionPair> there, back;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const dvec3 wo = directionAt(1 - 0.97 * a[k].x, a[k].y), wi = directionAt(1 - 0.97 * b[k].x, b[k].y);
      there.push_back({i, wo, wi});
      back.push_back({i, wi, wo});
    }
    const std::vector<ScatterValue> forwards = leaves.evaluate(there), backwards = leaves.evaluate(back);
    for (std::size_t k = 0; k < forwards.size(); ++k) {
      CAPTURE(i, k);
      REQUIRE(length(forwards[k].f - backwards[k].f) <= 200 * kRounding * length(forwards[k].f));
    }
  }
}

TEST_CASE("white plastic with a smooth boundary reflects all light, and a rough one no more") {
  const MaterialLeaves leaves({plastic(smooth, 0, 1, 1), plastic(smooth, 0, 1, 1, true), plastic(ggx, 0.1, 1, 1),
                               plastic(beckmann, 0.1, 1, 1), plastic(beckmann, 0.5, 1, 1), plastic(ggx, 1, 1, 1)});
  const std::vector<glm::vec3> numbers = latticeNumbers(50000);
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (const dvec3& wo : kPlasticViews) {
      const double albedo = meanWeight(scattered(leaves, i, wo, numbers)).x;
      CAPTURE(i, wo.z, albedo);
      // The fit of the internal reflectance is 0.1 % above Fresnel's.
      if (i < 2) CHECK(albedo == Approx(1).margin(3e-3));
      CHECK(albedo < 1.003);
    }
  }
}

TEST_CASE("light from the base of plastic takes the base's colour each time if it is nonlinear") {
  const MaterialLeaves leaves({plastic(smooth, 0, 0.5, 0), plastic(smooth, 0, 0.5, 0, true)});
  const auto at = [&](std::uint32_t material) {
    const DirectionPair pair{material, directionAt(0.8, 0.1), directionAt(0.7, 0.3)};
    return leaves.evaluate(std::vector{pair}).front().f.x;
  };
  const double internal = -1.4399 / (kIor * kIor) + 0.7099 / kIor + 0.6681 + 0.0636 * kIor;
  CHECK(at(1) / at(0) == Approx((1 - internal) / (1 - 0.5 * internal)).epsilon(1e-4));
}

TEST_CASE("below a normal map, other facets of plastic transmit light by its cosine to the geometric normal") {
  const MaterialLeaves leaves({plastic(smooth, 0, 0.7, 0), plastic(beckmann, 0.4, 0.7, 0)});
  const dvec3 geometric = normalize(dvec3(0.5, 0.2, 1)), wo = directionAt(0.8, 0.1), wi = directionAt(0.4, 0.3);
  REQUIRE(dot(wi, geometric) > 0);
  const double cosine = dot(wi, geometric), kappa = (1 - geometric.z) / 2;
  for (std::uint32_t i = 0; i < 2; ++i) {
    const std::vector<DirectionPair> pairs{{i, wo, wi}, {i, wo, directionAt(cosine, 0.5)}};
    const std::vector<ScatterValue> f = leaves.evaluate(pairs);
    const DirectionPair mapped{.material = i, .wo = wo, .wi = wi, .geometric = geometric};
    const double expected = f[0].f.x * wi.z + f[1].f.x * kappa * cosine;
    CHECK(leaves.evaluate(std::vector{mapped}).front().f.x * cosine == Approx(expected).epsilon(100 * kRounding));
  }
}

TEST_CASE("facets of normal maps of plastic scatter with the stated density", "[swiftshader-slow]") {
  const MaterialLeaves leaves({plastic(ggx, 0.3, 0.7, 0.9), plastic(beckmann, 0.5, 0.7, 0.9)});
  const SurfaceNumbers numbers;
  const dvec3 geometric = normalize(dvec3(0.7, 0.2, 1));
  for (std::uint32_t i = 0; i < 2; ++i) {
    scene::SurfaceParameters surface{.roughness = 1};
    CAPTURE(i);
    checkSurface(leaves, {i, surface, directionAt(0.9, 0.2), true, geometric}, numbers);
  }
}
