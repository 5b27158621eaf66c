// The densities of surfaces with OpenPBR's parameters: docs/light-transport.md sections 5.1 to 5.12.
#include <catch2/catch.hpp>
#include <functional>

#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/surface_density.h"
#include "tests/trace/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

const std::vector<dvec3> kSurfaceViews{directionAt(0.99, 0.05), directionAt(0.8, 0.42), directionAt(0.5, 0.32),
                                       directionAt(0.25, 0.7), directionAt(0.1, 0.81)};

struct Mixture {
  SurfaceParameters surface;
  bool outside = true;
};

const std::vector<Mixture> kMixtures{
    {{.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1}},
    {{.baseColour = {0.8f, 0.5f, 0.2f}}},
    {{.baseColour = {0.8f, 0.5f, 0.2f}, .metalness = 0.4f, .ior = 2}},
    {{.baseColour = {0.1f, 0.1f, 0.1f}, .specularColour = {1, 0.5f, 2}, .specularWeight = 0.7f, .ior = 1.8f}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1, .isThinWalled = false}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1, .isThinWalled = false}, false},
    {{.baseColour = {0.9f, 0.8f, 0.5f},
      .metalness = 0.2f,
      .specularWeight = 0.6f,
      .ior = 1.3f,
      .transmissionWeight = 0.6f,
      .isThinWalled = false,
      .coatWeight = 0.7f,
      .coatRoughness = 0.6f}},
    {{.baseColour = {0, 0, 0}, .specularWeight = 0, .sheenColour = {0.9f, 0.6f, 0.3f}}},
    {{.baseColour = {0.2f, 0.3f, 0.6f}, .sheenColour = {1, 0.8f, 0.5f}}},
    {{.baseColour = {0.9f, 0.8f, 0.5f},
      .metalness = 0.2f,
      .transmissionWeight = 0.6f,
      .isThinWalled = false,
      .coatWeight = 0.7f,
      .sheenColour = {0.3f, 0.8f, 0.5f},
      .coatRoughness = 0.6f}},
    {{.metalness = 1, .conductor = kGold}},
    {{.baseColour = {0.8f, 0.5f, 0.2f}, .metalness = 0.6f, .conductor = kGold}},
    {{.baseColour = {0.8f, 0.5f, 0.2f}, .metalness = 0.3f, .filmWeight = 0.9f, .filmThickness = 420}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 0.7f, .isThinWalled = false, .filmWeight = 1}, false},
    {{.specularColour = {1, 0.4f, 6},
      .specularWeight = 0.8f,
      .transmissionWeight = 0.8f,
      .isThinWalled = false,
      .filmWeight = 0.6f,
      .filmThickness = 420}},
    {{.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1, .anisotropy = 0.3f}},
    {{.baseColour = {0.9f, 0.6f, 0.2f},
      .metalness = 0.5f,
      .coatWeight = 0.7f,
      .coatRoughness = 0.6f,
      .anisotropy = 0.7f}},
    {{.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1, .anisotropy = 1}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1, .anisotropy = 0.6f}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 0.8f, .isThinWalled = false, .anisotropy = 0.5f}},
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 1, .isThinWalled = false, .anisotropy = 0.8f}, false}};

// every: each surface is seen from each direction. one: each surface is seen from one direction, each mixture from all.
enum class Views { one, every };

// Every mixture at every roughness.
class Cases {
 public:
  Cases() {
    for (const Mixture& mixture : kMixtures) {
      for (const float roughness : kRoughnesses) {
        mixtures_.push_back(mixture);
        mixtures_.back().surface.roughness = roughness;
        mixtures_.back().surface.sheenRoughness = roughness;
      }
    }
  }

  std::vector<scene::Material> materials() const {
    std::vector<scene::Material> materials;
    for (const Mixture& mixture : mixtures_) materials.push_back(materialOf(mixture.surface));
    return materials;
  }

  void forEach(Views views, const std::function<void(const SurfaceCase&)>& body) const {
    for (std::uint32_t i = 0; i < mixtures_.size(); ++i) {
      const auto& [surface, outside] = mixtures_[i];
      const std::size_t mixture = i / kRoughnesses.size();
      for (std::size_t view = 0; view < kSurfaceViews.size(); ++view) {
        if (views == Views::one && view != (mixture + i) % kSurfaceViews.size()) continue;
        const dvec3& wo = kSurfaceViews[view];
        INFO("mixture " << mixture << ", roughness " << surface.roughness << ", cosine " << wo.z);
        body({i, surface, wo, outside});
      }
    }
  }

 private:
  std::vector<Mixture> mixtures_;
};

void checkSurfaces(Views views) {
  const Cases cases;
  const MaterialLeaves leaves(cases.materials());
  const SurfaceNumbers numbers;
  cases.forEach(views, [&](const SurfaceCase& c) { checkSurface(leaves, c, numbers); });
}

// Coats of every roughness, over bases that are rougher than narrow coats.
const std::vector<SurfaceParameters> kCoated{
    {.baseColour = {0.7f, 0.1f, 0.05f}, .roughness = 0.5f, .coatWeight = 1},
    {.baseColour = {0.8f, 0.5f, 0.2f}, .metalness = 0.6f, .roughness = 0.4f, .coatWeight = 0.7f},
    {.baseColour = {0.9f, 0.8f, 0.5f}, .roughness = 0.6f, .transmissionWeight = 0.8f, .coatWeight = 1}};

}  // namespace

TEST_CASE("surfaces are sampled with the stated density, and their mean weight is the albedo by quadrature",
          "[swiftshader-slow]") {
  checkSurfaces(Views::one);
}

TEST_CASE("surfaces are sampled with the stated density from every direction", "[slow]") {
  checkSurfaces(Views::every);
}

TEST_CASE("coats of every roughness are sampled with the stated density", "[swiftshader-slow]") {
  std::vector<scene::Material> materials;
  for (const SurfaceParameters& coated : kCoated) {
    for (const float roughness : kRoughnesses) {
      materials.push_back(materialOf(coated));
      materials.back().surface->coatRoughness = roughness;
    }
  }
  const MaterialLeaves leaves(materials);
  const SurfaceNumbers numbers;
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const dvec3& wo : kSurfaceViews) {
      CAPTURE(i / kRoughnesses.size(), materials[i].surface->coatRoughness, wo.z);
      checkSurface(leaves, {i, *materials[i].surface, wo}, numbers);
    }
  }
}

TEST_CASE("facets of normal maps scatter with the stated density", "[swiftshader-slow]") {
  std::vector<scene::Material> materials;
  for (const float roughness : {0.4f, 1.0f}) {
    materials.push_back(materialOf({.baseColour = {0.8f, 0.5f, 0.2f}, .roughness = roughness}));
    materials.push_back(materialOf({.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1, .roughness = roughness}));
    materials.push_back(materialOf({.metalness = 0.5f, .roughness = roughness, .transmissionWeight = 0.5f}));
    materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 0.9f, .isThinWalled = false}));
    materials.push_back(materialOf({.roughness = roughness, .coatWeight = 1, .coatRoughness = 0.6f}));
    materials.push_back(materialOf({.sheenColour = {0.9f, 0.6f, 0.3f}, .sheenRoughness = roughness}));
  }
  const MaterialLeaves leaves(materials);
  const SurfaceNumbers numbers;
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    for (const double tilt : {0.1, 0.8}) {
      const dvec3 geometric = normalize(dvec3(std::sin(tilt), 0.3 * std::sin(tilt), std::cos(tilt)));
      for (const dvec3& wo : {directionAt(0.9, 0.2), directionAt(0.4, 0.05)}) {
        REQUIRE(dot(wo, geometric) > 0);
        CAPTURE(i, tilt, wo.z);
        checkSurface(leaves, {i, *materials[i].surface, wo, true, geometric}, numbers);
      }
    }
  }
}
