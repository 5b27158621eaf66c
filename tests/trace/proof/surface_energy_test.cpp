// The energy that surfaces scatter: docs/light-transport.md sections 5.1 to 5.12.
#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/hemisphere.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

// Each material is seen from every `stride`-th direction. The first one differs from material to material.
void checkWhiteSurfaces(std::uint32_t stride) {
  constexpr std::uint32_t kAngles = 16;
  std::vector<scene::Material> materials;
  for (const float roughness : kRoughnesses) {
    materials.push_back(materialOf({.metalness = 1, .roughness = roughness}));
    materials.push_back(materialOf({.roughness = roughness}));
    materials.push_back(materialOf({.metalness = 0.5f, .specularWeight = 0.6f, .roughness = roughness, .ior = 2}));
    materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 1, .coatWeight = 1}));
    materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 1, .isThinWalled = false}));
    materials.push_back(
        materialOf({.metalness = 0.5f, .roughness = roughness, .transmissionWeight = 0.5f, .isThinWalled = false}));
    materials.push_back(materialOf({.roughness = 0.5f, .sheenColour = {1, 1, 1}, .sheenRoughness = roughness}));
    materials.push_back(materialOf({.metalness = 1, .roughness = roughness, .filmWeight = 1}));
    materials.push_back(materialOf({.metalness = 0.5f,
                                    .roughness = roughness,
                                    .coatWeight = 0.5f,
                                    .sheenColour = {0.6f, 0.6f, 0.6f},
                                    .sheenRoughness = roughness}));
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(65536);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (std::uint32_t step = material % stride; step < kAngles; step += stride) {
      const dvec3 wo = directionAt((step + 0.5) / kAngles, 0.3);
      for (const bool outside : {true, false}) {
        if (!outside && materials[material].surface->isThinWalled)
          continue;  // scatters in the same way from both sides
        const double albedo = meanWeight(scattered(leaves, material, wo, numbers, outside)).x;
        CAPTURE(material % (materials.size() / kRoughnesses.size()), materials[material].surface->roughness, wo.z,
                outside);
        CHECK(albedo <= 1.001);
        CHECK(albedo >= 0.99);
      }
    }
  }
}

void checkWhiteAnisotropicSurfaces(std::uint32_t stride) {
  constexpr std::uint32_t kAngles = 8, kAzimuths = 5;
  std::vector<scene::Material> materials;
  for (const float roughness : {0.01f, 0.07f, 0.2f, 0.35f, 0.5f, 0.8f, 1.0f}) {
    for (const float strength : {0.05f, 0.22f, 0.5f, 0.73f, 0.9f, 1.0f}) {
      materials.push_back(materialOf({.metalness = 1, .roughness = roughness, .anisotropy = strength}));
      materials.push_back(materialOf({.roughness = roughness, .anisotropy = strength}));
      materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 1, .anisotropy = strength}));
    }
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(16384);
  double least = 1;
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (std::uint32_t step = material % stride; step < kAngles * kAzimuths; step += stride) {
      const std::uint32_t azimuth = step / kAngles;
      const dvec3 wo = directionAt((step % kAngles + 0.5) / kAngles, azimuth / (4.0 * (kAzimuths - 1)));
      const double albedo = meanWeight(scattered(leaves, material, wo, numbers)).x;
      CAPTURE(material % 3, materials[material].surface->roughness, materials[material].surface->anisotropy, wo.z,
              turns(wo.x, wo.y));
      CHECK(albedo <= 1.001);
      CHECK(albedo >= 0.98);
      least = std::min(least, albedo);
    }
  }
  CHECK(least < 1);
}

}  // namespace

TEST_CASE("white surfaces reflect everything within 1 percent, and never more than 1.001 of it", "[swiftshader-slow]") {
  checkWhiteSurfaces(4);
}

TEST_CASE("white surfaces reflect everything in every direction", "[slow]") { checkWhiteSurfaces(1); }

TEST_CASE("white anisotropic surfaces reflect everything within 2 percent, and never more than 1.001 of it",
          "[swiftshader-slow]") {
  checkWhiteAnisotropicSurfaces(5);
}

TEST_CASE("white anisotropic surfaces reflect everything in every direction", "[slow]") {
  checkWhiteAnisotropicSurfaces(1);
}

TEST_CASE("white glass below a thin film passes what the film does not reflect", "[swiftshader-slow]") {
  std::vector<scene::Material> materials;
  for (const float roughness : {0.01f, 0.05f, 0.2f, 0.35f, 0.5f, 0.7f, 1.0f}) {
    for (const auto& [thickness, ior] : {std::pair{150.0f, 1.5f}, {400.0f, 1.2f}, {400.0f, 1.5f}, {700.0f, 2.2f}}) {
      for (const bool thin : {true, false}) {
        materials.push_back(materialOf({.roughness = roughness,
                                        .ior = ior,
                                        .transmissionWeight = 1,
                                        .isThinWalled = thin,
                                        .filmWeight = 1,
                                        .filmThickness = thickness}));
      }
    }
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(16384);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (const double cosine : {0.1, 0.4, 0.7, 0.95}) {
      for (const bool outside : {true, false}) {
        const scene::SurfaceParameters& surface = *materials[material].surface;
        if (!outside && surface.isThinWalled) continue;
        const dvec3 albedo = meanWeight(scattered(leaves, material, directionAt(cosine, 0.3), numbers, outside));
        CAPTURE(surface.isThinWalled, surface.roughness, surface.filmThickness, cosine, outside);
        for (int channel = 0; channel < 3; ++channel) {
          CHECK(albedo[channel] <= (surface.isThinWalled ? 1.001 : 1.01));
          CHECK(albedo[channel] >= (surface.isThinWalled ? 0.998 : 0.95));
        }
      }
    }
  }
}

TEST_CASE("anisotropic glass that bounds a volume scatters 0.9 to 1.001 of the light") {
  std::vector<scene::Material> materials;
  for (const float roughness : {0.05f, 0.3f, 0.7f}) {
    for (const float strength : {0.1f, 0.4f, 0.7f, 1.0f}) {
      materials.push_back(
          materialOf({.roughness = roughness, .transmissionWeight = 1, .isThinWalled = false, .anisotropy = strength}));
    }
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(16384);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (const double cosine : {0.05, 0.3, 0.6, 0.95}) {
      for (const bool outside : {true, false}) {
        const double albedo = meanWeight(scattered(leaves, material, directionAt(cosine, 0.13), numbers, outside)).x;
        CAPTURE(materials[material].surface->roughness, materials[material].surface->anisotropy, cosine, outside);
        CHECK(albedo <= 1.001);
        CHECK(albedo >= 0.9);
      }
    }
  }
}
