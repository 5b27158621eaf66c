// Reciprocity of each lobe: docs/light-transport.md sections 5.2 to 5.12. Compensation and layers multiply a lobe by
// factors that depend on wo alone. For a cycle of directions a, b, c, these factors cancel in the products
// f(a, b) f(b, c) f(c, a) and f(b, a) f(c, b) f(a, c), which are equal if the rest is reciprocal. So would factors of
// wi cancel, which the quotients of lobes and bare microfacets exclude.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/reciprocity.h"
#include "tests/trace/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

struct Lobe {
  const char* name;
  SurfaceParameters surface;
  bool transmits = false;  // a thin wall: wi is on the other side
};

// Surfaces that consist of one lobe on the tested side.
const std::vector<Lobe> kLobes{
    {"coat", {.baseColour = {0, 0, 0}, .specularWeight = 0, .coatWeight = 0.8f}},
    {"dielectric", {.baseColour = {0, 0, 0}, .specularColour = {1, 0.5f, 2}, .specularWeight = 0.7f, .ior = 1.8f}},
    {"metal", {.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1}},
    {"conductor", {.metalness = 1, .conductor = kGold}},
    {"anisotropic conductor", {.metalness = 1, .anisotropy = 0.7f, .conductor = kGold}},
    {"film on metal", {.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1, .filmWeight = 1, .filmThickness = 420}},
    {"film on a dielectric", {.baseColour = {0, 0, 0}, .filmWeight = 1, .filmThickness = 300}},
    {"reflection by thin glass", {.transmissionWeight = 1}},
    {"transmission by thin glass", {.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1}, true},
    {"transmission by anisotropic thin glass", {.transmissionWeight = 1, .anisotropy = 0.6f}, true},
    {"transmission below a film", {.transmissionWeight = 1, .filmWeight = 1, .filmThickness = 420}, true},
    {"reflection by glass", {.transmissionWeight = 1, .isThinWalled = false}},
    {"reflection by anisotropic glass", {.transmissionWeight = 1, .isThinWalled = false, .anisotropy = 0.6f}}};

// Every lobe with every roughness.
std::vector<scene::Material> lobesOfAllRoughnesses() {
  std::vector<scene::Material> materials;
  for (const Lobe& lobe : kLobes) {
    for (const float roughness : kRoughnesses) {
      materials.push_back(materialOf(lobe.surface));
      materials.back().surface->roughness = roughness;
      materials.back().surface->coatRoughness = roughness;
    }
  }
  return materials;
}

constexpr std::size_t kCycles = 2000;

// Returns uniform directions of the upper hemisphere that are not at the horizon.
std::vector<dvec3> directionsOf(std::uint32_t seed) {
  std::vector<dvec3> directions;
  for (const glm::vec3& u : randomNumbers(kCycles, seed)) directions.push_back(directionAt(1 - 0.97 * u.x, u.y));
  return directions;
}

// Pairs that lead around cycles of three directions, forwards or backwards. `turned`: wi is below the surface.
std::vector<DirectionPair> cyclesOf(std::uint32_t material, bool backwards, bool turned) {
  const std::vector<dvec3> corners[3]{directionsOf(311), directionsOf(312), directionsOf(313)};
  std::vector<DirectionPair> pairs;
  for (std::size_t i = 0; i < kCycles; ++i) {
    for (std::size_t from = 0; from < 3; ++from) {
      dvec3 wo = corners[from][i], wi = corners[(from + 1) % 3][i];
      if (backwards) std::swap(wo, wi);
      if (turned) wi.z = -wi.z;
      pairs.push_back({material, wo, wi});
    }
  }
  return pairs;
}

// For each direction wo, two directions wi at the same angle to it, so that wo.h is the same.
std::vector<DirectionPair> equalAnglesOf() {
  const std::vector<dvec3> views = directionsOf(315), first = directionsOf(316);
  const std::vector<glm::vec3> turns = randomNumbers(kCycles, 317);
  std::vector<DirectionPair> pairs;
  for (std::size_t i = 0; i < kCycles; ++i) {
    const dvec3 &wo = views[i], &wi = first[i];
    const double angle = 2 * std::numbers::pi * turns[i].x;
    const dvec3 turned = std::cos(angle) * wi + std::sin(angle) * cross(wo, wi) +
                         (1 - std::cos(angle)) * dot(wo, wi) * wo;
    // A reflectance of (1 - wo.h)^5 must not be too small to be resolved.
    if (turned.z < 0.03 || dot(wo, wi) > 0.6) continue;
    pairs.push_back({0, wo, wi});
    pairs.push_back({0, wo, turned});
  }
  return pairs;
}

std::vector<ScatterValue> valuesOf(const MaterialLeaves& leaves, std::uint32_t material,
                                   std::vector<DirectionPair> pairs, bool turned) {
  for (DirectionPair& pair : pairs) {
    pair.material = material;
    if (turned) pair.wi.z = -pair.wi.z;
  }
  return leaves.evaluate(pairs);
}

using Values = std::function<std::vector<ScatterValue>(std::span<const DirectionPair>)>;

void checkCycles(const Values& values, std::uint32_t material, bool turned) {
  const std::vector<ScatterValue> forwards = values(cyclesOf(material, false, turned));
  const std::vector<ScatterValue> backwards = values(cyclesOf(material, true, turned));
  int compared = 0;
  for (std::size_t i = 0; i < forwards.size(); i += 3) {
    const dvec3 there = forwards[i].f * forwards[i + 1].f * forwards[i + 2].f;
    const dvec3 back = backwards[i].f * backwards[i + 1].f * backwards[i + 2].f;
    REQUIRE(length(there - back) <= 1000 * kRounding * length(there));
    compared += length(there) > 0 ? 1 : 0;
  }
  CHECK(compared > 1900);
}

}  // namespace

TEST_CASE("every lobe is reciprocal up to factors that depend on one direction") {
  const std::vector<scene::Material> materials = lobesOfAllRoughnesses();
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    const Lobe& lobe = kLobes[i / kRoughnesses.size()];
    CAPTURE(lobe.name, materials[i].surface->roughness);
    checkCycles([&](std::span<const DirectionPair> pairs) { return leaves.evaluate(pairs); }, i, lobe.transmits);
  }
}

TEST_CASE("every lobe is that of bare microfacets times a factor of wo and of its angle to the half vector") {
  const std::vector<DirectionPair> pairs = equalAnglesOf();
  REQUIRE(pairs.size() > 1000);
  std::vector<scene::Material> materials = lobesOfAllRoughnesses();
  const auto count = static_cast<std::uint32_t>(materials.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const SurfaceParameters& lobe = *materials[i].surface;
    materials.push_back(materialOf(
        {.baseColour = {0, 0, 0}, .metalness = 1, .roughness = lobe.roughness, .anisotropy = lobe.anisotropy}));
  }
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Lobe& lobe = kLobes[i / kRoughnesses.size()];
    const std::vector<ScatterValue> f = valuesOf(leaves, i, pairs, lobe.transmits),
                                    bare = valuesOf(leaves, count + i, pairs, false);
    CAPTURE(lobe.name, materials[i].surface->roughness);
    for (std::size_t k = 0; k < pairs.size(); k += 2) {
      const double here = f[k].f.y * bare[k + 1].f.y, there = f[k + 1].f.y * bare[k].f.y;
      REQUIRE(std::abs(here - there) <= 1000 * kRounding * here);
    }
  }
}

TEST_CASE("the diffuse lobe below a dielectric depends on one direction alone") {
  // It is the difference between a surface and the same one with a black base.
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    const MaterialLeaves leaves({materialOf({.baseColour = {0.8f, 0.8f, 0.8f}, .roughness = roughness}),
                                 materialOf({.baseColour = {0, 0, 0}, .roughness = roughness})});
    for (const dvec3& wo : directionsOf(314)) {
      if (wo.z < 0.1) continue;
      std::vector<DirectionPair> pairs;
      for (const std::uint32_t material : {0u, 1u}) {
        for (const dvec3& wi : {dvec3(0, 0, 1), dvec3(0.6, 0, 0.8)}) pairs.push_back({material, wo, wi});
      }
      const std::vector<ScatterValue> f = leaves.evaluate(pairs);
      CAPTURE(roughness, wo.z);
      REQUIRE(f[0].f.x - f[2].f.x == Approx(f[1].f.x - f[3].f.x).margin(20 * kRounding * (f[0].f.x + f[1].f.x)));
      REQUIRE(f[0].f.x - f[2].f.x > 0.01);
    }
  }
}

TEST_CASE("microfacets before their energy is compensated, and sheen, are reciprocal") {
  std::vector<scene::Material> materials;  // a reflectance of 0 at normal incidence has no compensation
  const SurfaceParameters black{.baseColour = {0, 0, 0}, .specularWeight = 0};
  for (const float roughness : kRoughnesses) {
    materials.push_back(materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness}));
    materials.push_back(
        materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness, .anisotropy = 0.7f}));
    SurfaceParameters velvet = black;
    velvet.sheenColour = {1, 1, 1};
    velvet.sheenRoughness = roughness;
    materials.push_back(materialOf(velvet));
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> first = randomNumbers(5000, 305), second = randomNumbers(5000, 306);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    const auto [there, back] = pairsBothWays(material, first, second);
    const std::vector<ScatterValue> f = leaves.evaluate(there), reversed = leaves.evaluate(back);
    for (std::size_t i = 0; i < f.size(); ++i) {
      CAPTURE(material, there[i].wo.z, there[i].wi.z);
      REQUIRE(length(f[i].f - reversed[i].f) <= 300 * kRounding * length(f[i].f) + 1e-12);
    }
  }
}

TEST_CASE("glass is reciprocal in both directions, up to factors that depend on only one direction",
          "[swiftshader-slow]") {
  // For two directions outside and two inside, these factors cancel in the ratio of the values around the cycle.
  std::vector<scene::Material> materials;
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 1, .isThinWalled = false}));
    materials.push_back(
        materialOf({.roughness = roughness, .transmissionWeight = 1, .isThinWalled = false, .anisotropy = 0.6f}));
  }
  // Single precision cannot resolve the transmittance of microfacets at grazing incidence, which is nearly 0.
  constexpr double kResolved = 1e-5, kResolvedFactor = 2e-3;
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> first = randomNumbers(8000, 307), second = randomNumbers(8000, 308);
  const auto turned = [](const dvec3& v) { return dvec3(v.x, v.y, -v.z); };
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    int compared = 0;
    for (std::size_t i = 0; i + 1 < first.size(); i += 2) {
      const auto above = [&](std::size_t k) { return directionAt(0.2 + 0.8 * first[k].x, 0.25 * first[k].y); };
      const auto below = [&](std::size_t k) { return directionAt(-0.7 - 0.3 * second[k].x, 0.5 + 0.25 * second[k].y); };
      double there = 1, back = 1, least = 1;
      for (const auto& [a, b] : {std::pair{i, i}, std::pair{i + 1, i + 1}}) {
        const std::size_t other = a == i ? i + 1 : i;
        // The frame of a view from inside has its z axis inside.
        const std::vector<DirectionPair> pairs{{material, above(a), below(b)},
                                               {material, turned(below(b)), turned(above(other)), false},
                                               {material, above(a), below(other)},
                                               {material, turned(below(b)), turned(above(a)), false}};
        const std::vector<ScatterValue> f = leaves.evaluate(pairs);
        there *= f[0].f.x * f[1].f.x;
        back *= f[2].f.x * f[3].f.x;
        for (const ScatterValue& value : f) least = std::min(least, value.f.x);
      }
      if (std::min(there, back) < kResolved || least < kResolvedFactor) continue;
      CHECK(there == Approx(back).epsilon(2000 * kRounding));
      ++compared;
    }
    CHECK(compared > 100);
  }
}
