// Lobes of surfaces with OpenPBR's parameters: docs/light-transport.md section 5.1 to 5.11.
#include <algorithm>
#include <catch2/catch.hpp>
#include <complex>
#include <functional>
#include <optional>
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

const scene::Conductor kGold{{0.143f, 0.375f, 1.442f}, {3.983f, 2.386f, 1.603f}};

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
    {{.baseColour = {0.9f, 0.8f, 0.5f}, .transmissionWeight = 0.7f, .isThinWalled = false, .filmWeight = 1}, false}};

struct Case {
  std::uint32_t material;
  SurfaceParameters surface;
  double alpha;
  dvec3 wo;
  bool outside;

  Passage transmission() const { return surface.isThinWalled ? Passage::thin : Passage::refracted; }
  double eta() const { return outside ? surface.ior : 1 / double{surface.ior}; }
};

// Every mixture at every roughness, seen from every direction.
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

  void forEach(const std::function<void(const Case&)>& body) const {
    for (std::uint32_t i = 0; i < mixtures_.size(); ++i) {
      const auto& [surface, outside] = mixtures_[i];
      for (const dvec3& wo : kSurfaceViews) {
        INFO("mixture " << i / kRoughnesses.size() << ", roughness " << surface.roughness << ", cosine " << wo.z);
        body({i, surface, std::pow(double{surface.roughness}, 2), wo, outside});
      }
    }
  }

 private:
  std::vector<Mixture> mixtures_;
};

// The cells of one side of a surface, and quadrature over them.
class Half {
 public:
  Half(const Case& c, bool transmitted) : case_(c), transmitted_(transmitted) {
    const bool hasHighlight = c.surface.metalness > 0 || c.surface.specularWeight > 0;
    if (hasHighlight && c.surface.roughness < kNarrow) {
      slopes_.emplace(kCellRows, 2 * kCellColumns, c.wo, c.alpha, transmitted ? c.transmission() : Passage::reflected,
                      c.eta());
      points_ = slopes_->points();
      return;
    }
    points_ = HemisphereGrid(2 * kCellRows, 2 * kCellColumns).points();
    if (transmitted) std::ranges::for_each(points_, [](auto& point) { point.direction.z = -point.direction.z; });
  }

  const std::vector<HemisphereGrid::Point>& points() const { return points_; }
  bool contains(const dvec3& wi) const { return (wi.z < 0) == transmitted_; }
  dvec2 placeOf(const dvec3& wi) const {
    if (slopes_) return slopes_->placeOf(wi);
    return {std::abs(wi.z), turns(wi.x, wi.y)};
  }
  std::vector<ScatterValue> values(const MaterialLeaves& leaves) const {
    std::vector<DirectionPair> pairs;
    for (const HemisphereGrid::Point& point : points_) {
      pairs.push_back({case_.material, case_.wo, point.direction, case_.outside});
    }
    return leaves.evaluate(pairs);
  }

 private:
  Case case_;
  bool transmitted_;
  std::optional<SlopeGrid> slopes_;
  std::vector<HemisphereGrid::Point> points_;
};

std::vector<Half> halvesOf(const Case& c) {
  std::vector<Half> halves{Half(c, false)};
  if (c.surface.transmissionWeight > 0) halves.emplace_back(c, true);
  return halves;
}

std::vector<Scattered> scattered(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo,
                                 std::span<const glm::vec3> numbers, bool outside = true) {
  std::vector<ScatterQuery> queries;
  for (const glm::vec3& u : numbers) queries.push_back({material, wo, u, outside});
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
    const std::vector<Scattered> samples = scattered(leaves, c.material, c.wo, numbers, c.outside);
    std::vector<double> observed, expected;
    double total = 0, counted = 0;
    for (const Half& half : halvesOf(c)) {
      Cells shares(kCellRows, kCellColumns), counts(kCellRows, kCellColumns);
      const std::vector<ScatterValue> values = half.values(leaves);
      for (std::size_t i = 0; i < values.size(); ++i) {
        shares.add(half.points()[i].place, kSurfaceSamples * values[i].pdf * half.points()[i].solidAngle);
      }
      for (const Scattered& sample : samples) {
        if (sample.lobe != render::Lobe::none && half.contains(sample.wi)) counts.add(half.placeOf(sample.wi));
      }
      expected.insert(expected.end(), shares.counts().begin(), shares.counts().end());
      observed.insert(observed.end(), counts.counts().begin(), counts.counts().end());
    }
    for (const double share : expected) total += share;
    for (const double count : observed) counted += count;
    CHECK(total <= 1.0005 * kSurfaceSamples);  // quadrature
    for (double& share : expected) share *= std::min(1.0, kSurfaceSamples / total);
    expected.push_back(std::max(0.0, kSurfaceSamples - total));  // samples that end the path
    observed.push_back(kSurfaceSamples - counted);
    poolRare(expected, observed);
    checkCounts(observed, expected);
  });
}

TEST_CASE("the mean weight of a surface's samples is the albedo computed by quadrature") {
  const Cases cases;
  const MaterialLeaves leaves(cases.materials());
  const std::vector<glm::vec3> numbers = latticeNumbers(50000);
  cases.forEach([&](const Case& c) {
    dvec3 albedo(0);
    for (const Half& half : halvesOf(c)) {
      const std::vector<ScatterValue> values = half.values(leaves);
      for (std::size_t i = 0; i < values.size(); ++i) {
        albedo += values[i].f * (std::abs(half.points()[i].direction.z) * half.points()[i].solidAngle);
      }
    }
    const dvec3 mean = meanWeight(scattered(leaves, c.material, c.wo, numbers, c.outside));
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
    for (int step = 0; step < kAngles; ++step) {
      const dvec3 wo = directionAt((step + 0.5) / kAngles, 0.3);
      for (const bool outside : {true, false}) {
        if (!outside && materials[material].surface->isThinWalled) continue;  // scatters alike from both sides
        const double albedo = meanWeight(scattered(leaves, material, wo, numbers, outside)).x;
        CAPTURE(material % (materials.size() / kRoughnesses.size()), materials[material].surface->roughness, wo.z,
                outside);
        CHECK(albedo <= 1.001);
        CHECK(albedo >= 0.99);
      }
    }
  }
}

TEST_CASE("microfacets before their energy is compensated, and sheen, are reciprocal") {
  std::vector<scene::Material> materials;  // a reflectance of 0 at normal incidence leaves nothing to compensate
  const SurfaceParameters black{.baseColour = {0, 0, 0}, .specularWeight = 0};
  for (const float roughness : kRoughnesses) {
    materials.push_back(materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness}));
    SurfaceParameters velvet = black;
    velvet.sheenColour = {1, 1, 1};
    velvet.sheenRoughness = roughness;
    materials.push_back(materialOf(velvet));
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

TEST_CASE("glass is reciprocal in both directions, up to factors that depend on one direction alone") {
  // For two directions outside and two inside, these factors cancel in the ratio of the values around the cycle.
  std::vector<scene::Material> materials;
  for (const float roughness : {0.2f, 0.5f, 1.0f}) {
    materials.push_back(materialOf({.roughness = roughness, .transmissionWeight = 1, .isThinWalled = false}));
  }
  // Single precision cannot resolve the transmittance of microfacets at grazing incidence, which is nearly 0.
  constexpr double kResolved = 1e-5;
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> first = randomNumbers(8000, 307), second = randomNumbers(8000, 308);
  const auto turned = [](const dvec3& v) { return dvec3(v.x, v.y, -v.z); };
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    int compared = 0;
    for (std::size_t i = 0; i + 1 < first.size(); i += 2) {
      const auto above = [&](std::size_t k) { return directionAt(0.2 + 0.8 * first[k].x, 0.25 * first[k].y); };
      const auto below = [&](std::size_t k) { return directionAt(-0.7 - 0.3 * second[k].x, 0.5 + 0.25 * second[k].y); };
      double there = 1, back = 1;
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
      }
      if (std::min(there, back) < kResolved) continue;
      CHECK(there == Approx(back).epsilon(2000 * kRounding));
      ++compared;
    }
    CHECK(compared > 100);
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

TEST_CASE("sheen has the values of the closed form") {
  // Computed to ten digits from the formulas of KHR_materials_sheen, and for the last the factor 0.25/0.258: roughness,
  // cosines, turn between the azimuths, value.
  struct Value {
    float roughness;
    double cosO, cosI, turn, f;
  };
  const std::vector<Value> values{{0.5f, 0.3, 0.3, 0.0, 0.3272520834},
                                  {0.5f, 0.8, 0.25, 0.2, 0.08603476271},
                                  {1, 0.6, 0.9, 0.4, 0.0455633868},
                                  {0.25f, 0.1, 0.15, 0.02, 1.671900698}};
  std::vector<scene::Material> materials;
  for (const Value& value : values) {
    materials.push_back(materialOf({.baseColour = {0, 0, 0},
                                    .specularWeight = 0,
                                    .sheenColour = {1, 0.5f, 0},
                                    .sheenRoughness = value.roughness}));
  }
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const dvec3 wo = directionAt(values[i].cosO, 0.1), wi = directionAt(values[i].cosI, 0.1 + values[i].turn);
    const dvec3 f = leaves.evaluate(std::vector<DirectionPair>{{i, wo, wi}}).front().f;
    CAPTURE(i);
    CHECK(f.x == Approx(values[i].f).epsilon(100 * kRounding + 1e-6));
    CHECK(f.y == Approx(values[i].f / 2).epsilon(100 * kRounding + 1e-6));
    CHECK(f.z == 0);
  }
}

TEST_CASE("conductors reflect as Fresnel's equations state, in complex numbers and with the published values of gold") {
  const float roughness = 0.3f;
  const MaterialLeaves leaves({materialOf({.metalness = 1, .roughness = roughness, .conductor = kGold}),
                               materialOf({.metalness = 1, .roughness = roughness})});
  for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const dvec3 gold = leaves.evaluate(std::vector<DirectionPair>{{0, wo, wi}}).front().f;
    const double white = valueAt(leaves, 1, wo, wi);  // compensated for a reflectance of 1
    for (int channel = 0; channel < 3; ++channel) {
      const std::complex<double> index(kGold.ior[channel], kGold.extinction[channel]);
      const auto reflectance = [&](double x) {
        const std::complex<double> inside = std::sqrt(1.0 - (1 - x * x) / (index * index));
        return (std::norm((x - index * inside) / (x + index * inside)) +
                std::norm((index * x - inside) / (index * x + inside))) /
               2;
      };
      const double normal = reflectance(1), alpha = std::pow(double{roughness}, 2);
      const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
      const double once = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);  // D V at h = z
      const double compensation = 1 + normal * (white / once - 1);
      CAPTURE(cosine, channel);
      CHECK(gold[channel] == Approx(once * compensation * reflectance(cosine)).epsilon(100 * kRounding + 1e-5));
    }
  }
}

TEST_CASE("thin films have the reflectance that the formulas of KHR_materials_iridescence give") {
  // Computed from these formulas to ten digits, with the cosine inside of the film in the path difference: cosine,
  // index and thickness of the film, grey reflectance of the base, and the three channels.
  struct Value {
    double cosine;
    float ior, thickness, base;
    dvec3 reflectance;
  };
  const std::vector<Value> values{{1, 1.3f, 400, 0.5f, {0.3411227856, 0.4951023496, 0.3802559227}},
                                  {0.7, 1.3f, 400, 0.04f, {0.0005240861571, 0.01037269638, 0.04155650075}},
                                  {0.3, 1.8f, 250, 0.04f, {0.2194129015, 0.2974542537, 0.2593192126}},
                                  {0.5, 1.5f, 900, 0.9f, {0.8230353566, 0.8799916314, 0.8673222819}}};
  const float roughness = 0.3f;
  std::vector<scene::Material> materials{materialOf({.metalness = 1, .roughness = roughness})};
  for (const Value& value : values) {
    materials.push_back(materialOf({.baseColour = glm::vec3(value.base),
                                    .metalness = 1,
                                    .roughness = roughness,
                                    .filmWeight = 1,
                                    .filmIor = value.ior,
                                    .filmThickness = value.thickness}));
  }
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const double cosine = values[i].cosine, alpha = std::pow(double{roughness}, 2);
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const dvec3 f = leaves.evaluate(std::vector<DirectionPair>{{i + 1, wo, wi}}).front().f;
    const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
    const double once = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);
    const dvec3 compensation = 1.0 + values[i].reflectance * (valueAt(leaves, 0, wo, wi) / once - 1);
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(i, channel, values[i].reflectance[channel]);
      const double expected = once * compensation[channel] * values[i].reflectance[channel];
      CHECK(f[channel] == Approx(expected).epsilon(100 * kRounding).margin(once * (kRounding + 1e-6)));
    }
  }
}
