// The asymmetry that compensation, layers and normal maps leave: docs/light-transport.md sections 5.4, 5.5, 5.7 to 5.9.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <span>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/reciprocity.h"
#include "tests/trace/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

constexpr std::size_t kPairs = 20000;

// Statistics of |f(a, b) - f(b, a)| divided by the mean of both, over uniform pairs of directions.
struct Asymmetry {
  double median;
  double largest;
};

struct Expected {
  const char* name;
  SurfaceParameters surface;
  Asymmetry asymmetry;
};

Asymmetry asymmetryOf(std::span<const double> there, std::span<const double> back) {
  std::vector<double> all;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const double mean = (there[i] + back[i]) / 2;
    if (mean > 0) all.push_back(std::abs(there[i] - back[i]) / mean);
  }
  REQUIRE_FALSE(all.empty());
  std::sort(all.begin(), all.end());
  return {all[all.size() / 2], all.back()};
}

std::vector<double> greenOf(std::span<const ScatterValue> values) {
  std::vector<double> green;
  for (const ScatterValue& value : values) green.push_back(value.f.y);
  return green;
}

void checkAsymmetry(const Asymmetry& found, const Expected& expected) {
  CAPTURE(expected.name);
  CHECK(found.median == Approx(expected.asymmetry.median).epsilon(0.01).margin(10 * kRounding));
  CHECK(found.largest == Approx(expected.asymmetry.largest).epsilon(0.01).margin(1000 * kRounding));
}

// A mapped surface in the frame of its geometric normal: the mean over the facets that are seen from `wo`.
class MappedSurface {
 public:
  MappedSurface(std::uint32_t material, double tilt)
      : material_(material), x_(std::cos(tilt), 0, -std::sin(tilt)), normal_(std::sin(tilt), 0, std::cos(tilt)) {}

  std::vector<double> values(const MaterialLeaves& leaves, std::span<const DirectionPair> pairs) const {
    std::vector<DirectionPair> seen;
    std::vector<double> shares;
    for (const DirectionPair& pair : pairs) {
      const dvec3 wo = toFacet(pair.wo), wi = toFacet(pair.wi);
      const dvec3 along = dvec3(0, 0, 1) - normal_.z * normal_;
      const double direct = std::max(0.0, wo.z), mirrored = std::max(0.0, -dot(wo, along));
      const dvec3 reflected = wo - 2 * dot(wo, along) / dot(along, along) * along;
      seen.push_back({material_, wo, wi, true, {}, normal_});
      seen.push_back({material_, reflected, wi, true, {}, normal_});
      shares.push_back(direct / (direct + mirrored));
      shares.push_back(mirrored / (direct + mirrored));
    }
    const std::vector<double> parts = greenOf(leaves.evaluate(seen));
    std::vector<double> sums;
    for (std::size_t i = 0; i < parts.size(); i += 2) {
      sums.push_back((shares[i] > 0 ? shares[i] * parts[i] : 0) +
                     (shares[i + 1] > 0 ? shares[i + 1] * parts[i + 1] : 0));
    }
    return sums;
  }

 private:
  dvec3 toFacet(const dvec3& w) const { return w.x * x_ + w.y * dvec3(0, 1, 0) + w.z * normal_; }

  std::uint32_t material_;
  dvec3 x_, normal_;  // axes of the geometric frame in that of the facet
};

const std::vector<Expected> kLayered{
    {"white metal, roughness 0.2", {.metalness = 1, .roughness = 0.2f}, {0.00736, 0.1138}},
    {"white metal, roughness 0.5", {.metalness = 1, .roughness = 0.5f}, {0.03403, 0.175}},
    {"white metal, roughness 1", {.metalness = 1, .roughness = 1}, {0.2943, 1.05}},
    {"white glass, thin, roughness 1", {.roughness = 1, .transmissionWeight = 1}, {0.2943, 1.05}},
    {"white plastic, roughness 0.2", {.roughness = 0.2f}, {0.1285, 0.8753}},
    {"white plastic, roughness 0.5", {.roughness = 0.5f}, {0.04016, 0.2136}},
    {"white plastic, roughness 1", {.roughness = 1}, {0.01184, 0.07527}},
    {"coat of roughness 0.2 on white", {.specularWeight = 0, .coatWeight = 1, .coatRoughness = 0.2f}, {0.1423, 1.833}},
    {"coat of roughness 0.6 on white", {.specularWeight = 0, .coatWeight = 1, .coatRoughness = 0.6f}, {0.06533, 1.367}},
    {"white sheen of roughness 0.3 on white",
     {.specularWeight = 0, .sheenColour = {1, 1, 1}, .sheenRoughness = 0.3f},
     {0.1188, 1.699}},
    {"white sheen of roughness 1 on white",
     {.specularWeight = 0, .sheenColour = {1, 1, 1}, .sheenRoughness = 1},
     {0.1517, 0.9592}}};

const std::vector<Expected> kMapped{{"diffuse", {.specularWeight = 0}, {0.9307, 2}},
                                    {"white plastic, roughness 0.5", {.roughness = 0.5f}, {0.9402, 2}},
                                    {"white metal, roughness 0.5", {.metalness = 1, .roughness = 0.5f}, {1.309, 2}}};

std::vector<scene::Material> materialsOf(std::span<const Expected> surfaces) {
  std::vector<scene::Material> materials;
  for (const Expected& expected : surfaces) materials.push_back(materialOf(expected.surface));
  return materials;
}

}  // namespace

TEST_CASE("compensation and layers are asymmetric by the stated figures") {
  const MaterialLeaves leaves(materialsOf(kLayered));
  const std::vector<glm::vec3> first = randomNumbers(kPairs, 321), second = randomNumbers(kPairs, 322);
  for (std::uint32_t i = 0; i < kLayered.size(); ++i) {
    const auto [there, back] = pairsBothWays(i, first, second);
    checkAsymmetry(asymmetryOf(greenOf(leaves.evaluate(there)), greenOf(leaves.evaluate(back))), kLayered[i]);
  }
}

TEST_CASE("normal maps are asymmetric by the stated figures") {
  const MaterialLeaves leaves(materialsOf(kMapped));
  const std::vector<glm::vec3> first = randomNumbers(kPairs, 321), second = randomNumbers(kPairs, 322);
  for (std::uint32_t i = 0; i < kMapped.size(); ++i) {
    const auto [there, back] = pairsBothWays(i, first, second);
    const MappedSurface tilted(i, std::numbers::pi / 6);
    checkAsymmetry(asymmetryOf(tilted.values(leaves, there), tilted.values(leaves, back)), kMapped[i]);
  }
}
