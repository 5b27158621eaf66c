// Lobes of surfaces with OpenPBR's parameters: docs/light-transport.md section 5.1 to 5.4.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <utility>

#include "tests/proof/cells.h"
#include "tests/proof/chi_square.h"
#include "tests/proof/hemisphere.h"
#include "tests/proof/leaves.h"
#include "tests/proof/numbers.h"
#include "tests/proof/slope_grid.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

constexpr std::size_t kSurfaceSamples = 200000;
constexpr int kCellRows = 24, kCellColumns = 24;
constexpr double kNarrow = 0.3;  // up to this roughness, cells follow the highlight
const std::vector<float> kRoughnesses{0.01f, 0.05f, 0.2f, 0.5f, 1};
const std::vector<dvec3> kSurfaceViews{directionAt(0.99, 0.05), directionAt(0.8, 0.42), directionAt(0.5, 0.32),
                                       directionAt(0.25, 0.7), directionAt(0.1, 0.81)};

scene::Material materialOf(const SurfaceParameters& surface) {
  scene::Material material;
  material.surface = surface;
  return material;
}

const std::vector<SurfaceParameters> kMixtures{
    {.baseColour = {0.9f, 0.6f, 0.2f}, .metalness = 1},
    {.baseColour = {0.8f, 0.5f, 0.2f}},
    {.baseColour = {0.8f, 0.5f, 0.2f}, .metalness = 0.4f, .ior = 2},
    {.baseColour = {0.1f, 0.1f, 0.1f}, .specularColour = {1, 0.5f, 2}, .specularWeight = 0.7f, .ior = 1.8f}};

struct Case {
  std::uint32_t material;
  SurfaceParameters surface;
  double alpha;
  dvec3 wo;
};

// Every mixture at every roughness, seen from every direction.
class Cases {
 public:
  Cases() {
    for (const SurfaceParameters& mixture : kMixtures) {
      for (const float roughness : kRoughnesses) {
        surfaces_.push_back(mixture);
        surfaces_.back().roughness = roughness;
      }
    }
  }

  std::vector<scene::Material> materials() const {
    std::vector<scene::Material> materials;
    for (const SurfaceParameters& surface : surfaces_) materials.push_back(materialOf(surface));
    return materials;
  }

  void forEach(const std::function<void(const Case&)>& body) const {
    for (std::uint32_t i = 0; i < surfaces_.size(); ++i) {
      for (const dvec3& wo : kSurfaceViews) {
        INFO("mixture " << i / kRoughnesses.size() << ", roughness " << surfaces_[i].roughness << ", cosine " << wo.z);
        body({i, surfaces_[i], std::pow(double{surfaces_[i].roughness}, 2), wo});
      }
    }
  }

 private:
  std::vector<SurfaceParameters> surfaces_;
};

std::vector<HemisphereGrid::Point> pointsOf(const Case& c) {
  if (c.surface.roughness < kNarrow) return SlopeGrid(kCellRows, 2 * kCellColumns, c.wo, c.alpha).points();
  return HemisphereGrid(2 * kCellRows, 2 * kCellColumns).points();
}

dvec2 placeOf(const Case& c, const dvec3& wi) {
  if (c.surface.roughness < kNarrow) return SlopeGrid(0, 0, c.wo, c.alpha).placeOf(wi);
  return {wi.z, turns(wi.x, wi.y)};
}

std::vector<ScatterValue> valuesAt(const MaterialLeaves& leaves, std::span<const HemisphereGrid::Point> points,
                                   const Case& c) {
  std::vector<DirectionPair> pairs;
  for (const HemisphereGrid::Point& point : points) pairs.push_back({c.material, c.wo, point.direction});
  return leaves.evaluate(pairs);
}

std::vector<Scattered> scattered(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo,
                                 std::span<const glm::vec3> numbers) {
  std::vector<ScatterQuery> queries;
  for (const glm::vec3& u : numbers) queries.push_back({material, wo, u});
  return leaves.sample(queries);
}

dvec3 meanWeight(std::span<const Scattered> samples) {
  dvec3 sum(0);
  for (const Scattered& sample : samples) sum += sample.weight;
  return sum / static_cast<double>(samples.size());
}

// Adds cells in which less than one sample is expected to the last cell: quadrature may not have a point where a cell
// reaches above the horizon.
void poolRare(std::vector<double>& expected, std::vector<double>& observed) {
  for (std::size_t i = 0; i + 1 < expected.size(); ++i) {
    if (expected[i] >= 1) continue;
    expected.back() += std::exchange(expected[i], 0);
    observed.back() += std::exchange(observed[i], 0);
  }
}

double valueAt(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo, const dvec3& wi) {
  return leaves.evaluate(std::vector<DirectionPair>{{material, wo, wi}}).front().f.x;
}

}  // namespace

TEST_CASE("surfaces are sampled with the stated density at five roughnesses and five angles") {
  const Cases cases;
  const MaterialLeaves leaves(cases.materials());
  const std::vector<glm::vec3> numbers = randomNumbers(kSurfaceSamples, 301);
  cases.forEach([&](const Case& c) {
    const std::vector<HemisphereGrid::Point> points = pointsOf(c);
    const std::vector<ScatterValue> values = valuesAt(leaves, points, c);
    Cells expected(kCellRows, kCellColumns), observed(kCellRows, kCellColumns);
    double above = 0;
    for (std::size_t i = 0; i < values.size(); ++i) above += values[i].pdf * points[i].solidAngle;
    CHECK(above <= 1.0005);  // quadrature
    const double scale = kSurfaceSamples / std::max(1.0, above);
    for (std::size_t i = 0; i < values.size(); ++i) {
      expected.add(points[i].place, scale * values[i].pdf * points[i].solidAngle);
    }
    expected.addOutside(kSurfaceSamples - scale * above);
    for (const Scattered& sample : scattered(leaves, c.material, c.wo, numbers)) {
      if (sample.lobe == render::Lobe::none)
        observed.addOutside();
      else
        observed.add(placeOf(c, sample.wi));
    }
    poolRare(expected.counts(), observed.counts());
    checkCounts(observed.counts(), expected.counts());
  });
}

TEST_CASE("the mean weight of a surface's samples is the albedo computed by quadrature") {
  const Cases cases;
  const MaterialLeaves leaves(cases.materials());
  const std::vector<glm::vec3> numbers = latticeNumbers(50000);
  cases.forEach([&](const Case& c) {
    const std::vector<HemisphereGrid::Point> points = pointsOf(c);
    const std::vector<ScatterValue> values = valuesAt(leaves, points, c);
    dvec3 albedo(0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      albedo += values[i].f * (points[i].direction.z * points[i].solidAngle);
    }
    const dvec3 mean = meanWeight(scattered(leaves, c.material, c.wo, numbers));
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(channel, albedo[channel]);
      CHECK(mean[channel] == Approx(albedo[channel]).margin(2e-3));
    }
  });
}

TEST_CASE("white surfaces reflect everything within 1 percent, and never more than 1.001 of it") {
  constexpr int kAngles = 16;
  std::vector<scene::Material> materials;
  for (const float roughness : kRoughnesses) {
    materials.push_back(materialOf({.metalness = 1, .roughness = roughness}));
    materials.push_back(materialOf({.roughness = roughness}));
    materials.push_back(materialOf({.metalness = 0.5f, .specularWeight = 0.6f, .roughness = roughness, .ior = 2}));
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(65536);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (int step = 0; step < kAngles; ++step) {
      const dvec3 wo = directionAt((step + 0.5) / kAngles, 0.3);
      const double albedo = meanWeight(scattered(leaves, material, wo, numbers)).x;
      CAPTURE(material % 3, materials[material].surface->roughness, wo.z);
      CHECK(albedo <= 1.001);
      CHECK(albedo >= 0.99);
    }
  }
}

TEST_CASE("microfacets are reciprocal before their energy is compensated") {
  std::vector<scene::Material> materials;  // a reflectance of 0 at normal incidence leaves nothing to compensate
  for (const float roughness : kRoughnesses) {
    materials.push_back(materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness}));
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> first = randomNumbers(5000, 305), second = randomNumbers(5000, 306);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    std::vector<DirectionPair> there, back;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const dvec3 a = directionAt(1 - double{first[i].x}, first[i].y);
      const dvec3 b = directionAt(1 - double{second[i].x}, second[i].y);
      there.push_back({material, a, b});
      back.push_back({material, b, a});
    }
    const std::vector<ScatterValue> f = leaves.evaluate(there), reversed = leaves.evaluate(back);
    for (std::size_t i = 0; i < f.size(); ++i) {
      CAPTURE(material, there[i].wo.z, there[i].wi.z);
      REQUIRE(length(f[i].f - reversed[i].f) <= 300 * kRounding * length(f[i].f) + 1e-12);
    }
  }
}

TEST_CASE("a highlight's centre has the value of the closed form, with Schlick's reflectance") {
  const float roughness = 0.3f;
  const MaterialLeaves leaves({materialOf({.baseColour = {0, 0, 0}, .roughness = roughness, .ior = 1.5f}),
                               materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness}),
                               materialOf({.baseColour = {0, 0, 0}, .specularWeight = 0.5f, .roughness = roughness})});
  const double alpha = std::pow(double{roughness}, 2);
  for (const double cosine : {1.0, 0.7, 0.3}) {
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
    const double white = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);  // D V at h = z
    const double grazing = std::pow(1 - cosine, 5), reflectance = 0.04 + 0.96 * grazing;
    const double coated = valueAt(leaves, 0, wo, wi);
    CAPTURE(cosine);
    CHECK(valueAt(leaves, 1, wo, wi) == Approx(white * grazing).epsilon(1e-4).margin(1e-6));
    CHECK(coated >= white * reflectance);  // compensation adds less than 4 percent of what is lost
    CHECK(coated <= white * reflectance * 1.01);
    CHECK(valueAt(leaves, 2, wo, wi) == Approx(coated / 2).epsilon(1e-4));
  }
}
