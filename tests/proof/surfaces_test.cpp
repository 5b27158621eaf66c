// The densities of surfaces with OpenPBR's parameters: docs/light-transport.md sections 5.1 to 5.12.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "tests/proof/cells.h"
#include "tests/proof/chi_square.h"
#include "tests/proof/hemisphere.h"
#include "tests/proof/leaves.h"
#include "tests/proof/numbers.h"
#include "tests/proof/slope_grid.h"
#include "tests/proof/surface_samples.h"

using namespace candela;
using namespace candela::proof;
using scene::SurfaceParameters;

namespace {

constexpr std::size_t kSurfaceSamples = 100000;
constexpr int kCellRows = 24, kCellColumns = 24;
constexpr double kNarrow = 0.3;  // up to this roughness, cells follow the highlight
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

struct Case {
  std::uint32_t material;
  SurfaceParameters surface;
  dvec2 alpha;
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
        const double alpha = std::pow(double{surface.roughness}, 2), strength = surface.anisotropy;
        body({i, surface, {std::lerp(alpha, 1.0, strength * strength), alpha}, wo, outside});
      }
    }
  }

 private:
  std::vector<Mixture> mixtures_;
};

// The cells of one side of a surface, and quadrature over them. Cells that follow the highlight resolve narrow lobes,
// those of the hemisphere broad lobes: in the cells of a long and narrow highlight, a broad lobe fills only a narrow
// range of azimuths. Where a surface may have both, a direction belongs to the former with a probability that falls
// smoothly with the density of their quadrature, so that each kind of cells integrates the densities that it resolves.
class Half {
 public:
  Half(const Case& c, bool transmitted) : case_(c), transmitted_(transmitted) {
    const bool hasHighlight = c.surface.metalness > 0 || c.surface.specularWeight > 0;
    if (hasHighlight && c.surface.roughness < kNarrow) {
      slopes_.emplace(hasBoth() ? fineNodes() : nodes(), c.wo, c.alpha,
                      transmitted ? c.transmission() : Passage::reflected, c.eta());
      addSlopes();
    }
    if (!slopes_ || hasBoth()) addHemisphere();
  }

  bool contains(const dvec3& wi) const { return (wi.z < 0) == transmitted_; }
  const std::vector<QuadraturePoint>& points() const { return points_; }
  std::vector<ScatterValue> values(const MaterialLeaves& leaves) const {
    std::vector<DirectionPair> pairs;
    for (const QuadraturePoint& point : points_) {
      pairs.push_back({case_.material, case_.wo, point.direction, case_.outside});
    }
    return leaves.evaluate(pairs);
  }

  /// Returns the counts that a density implies in all cells.
  std::vector<double> expected(const std::vector<ScatterValue>& values) const {
    Cells highlight(kCellRows, kCellColumns), hemisphere(kCellRows, kCellColumns);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Cells& cells = i < highlightPoints_ ? highlight : hemisphere;
      cells.add(points_[i].place, kSurfaceSamples * values[i].pdf * points_[i].solidAngle);
    }
    return joined(highlight, hemisphere);
  }
  dvec3 albedo(const std::vector<ScatterValue>& values) const {
    dvec3 sum(0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += values[i].f * (std::abs(points_[i].direction.z) * points_[i].solidAngle);
    }
    return sum;
  }

  /// Counts samples in all cells. `coins` in [0, 1) choose between the cells.
  std::vector<double> observed(std::span<const Scattered> samples, std::span<const glm::vec3> coins) const {
    Cells highlight(kCellRows, kCellColumns), hemisphere(kCellRows, kCellColumns);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const dvec3& wi = samples[i].wi;
      if (samples[i].lobe == render::Lobe::none || !contains(wi)) continue;
      if (coins[i].x < highlightShare(wi))
        highlight.add(slopes_->placeOf(wi));
      else
        hemisphere.add({std::abs(wi.z), turns(wi.x, wi.y)});
    }
    return joined(highlight, hemisphere);
  }

 private:
  bool hasBoth() const { return case_.surface.anisotropy > 0; }

  static std::span<const QuadraturePoint> nodes() {
    static const HemisphereGrid grid(kCellRows, 2 * kCellColumns);
    return grid.points();
  }
  // The horizon cuts anisotropic highlights: many cells with few points integrate densities that are not smooth.
  static std::span<const QuadraturePoint> fineNodes() {
    static const GaussGrid<3> grid(8 * kCellRows, 8 * kCellColumns);
    return grid.points();
  }

  // Returns the probability with which a direction belongs to the cells of the highlight.
  double highlightShare(const dvec3& wi) const {
    if (!slopes_ || !hasBoth()) return slopes_ ? 1 : 0;
    const double ratio = slopes_->spreadAt(wi) / (2 * std::numbers::pi);
    return 1 / (1 + ratio * ratio);
  }

  void addSlopes() {
    points_ = slopes_->points();
    highlightPoints_ = points_.size();
    for (QuadraturePoint& point : points_) point.solidAngle *= highlightShare(point.direction);
  }

  void addHemisphere() {
    const HemisphereGrid hemisphere(2 * kCellRows, 2 * kCellColumns);
    for (QuadraturePoint point : hemisphere.points()) {
      if (transmitted_) point.direction.z = -point.direction.z;
      point.solidAngle *= 1 - highlightShare(point.direction);
      points_.push_back(point);
    }
  }

  static std::vector<double> joined(const Cells& first, const Cells& second) {
    std::vector<double> counts = first.counts();
    counts.insert(counts.end(), second.counts().begin(), second.counts().end());
    return counts;
  }

  Case case_;
  bool transmitted_;
  std::optional<SlopeGrid> slopes_;
  std::vector<QuadraturePoint> points_;  // first those of the highlight
  std::size_t highlightPoints_ = 0;
};

std::vector<Half> halvesOf(const Case& c) {
  std::vector<Half> halves{Half(c, false)};
  if (c.surface.transmissionWeight > 0) halves.emplace_back(c, true);
  return halves;
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

// `observed` and `expected` have the samples and the quadrature of all cells.
void checkDensity(std::vector<double>& observed, std::vector<double>& expected) {
  const double total = std::accumulate(expected.begin(), expected.end(), 0.0);
  const double counted = std::accumulate(observed.begin(), observed.end(), 0.0);
  CHECK(total <= 1.0005 * kSurfaceSamples);  // quadrature
  for (double& share : expected) share *= std::min(1.0, kSurfaceSamples / total);
  expected.push_back(std::max(0.0, kSurfaceSamples - total));  // samples that end the path
  observed.push_back(kSurfaceSamples - counted);
  poolRare(expected, observed);
  checkCounts(observed, expected);
}

void checkWeight(const dvec3& mean, const dvec3& albedo) {
  for (int channel = 0; channel < 3; ++channel) {
    CAPTURE(channel, albedo[channel]);
    CHECK(mean[channel] == Approx(albedo[channel]).margin(2e-3));
  }
}

void append(const std::vector<double>& counts, std::vector<double>& all) {
  all.insert(all.end(), counts.begin(), counts.end());
}

}  // namespace

TEST_CASE("surfaces are sampled with the stated density, and their mean weight is the albedo by quadrature",
          "[swiftshader-slow]") {
  const Cases cases;
  const MaterialLeaves leaves(cases.materials());
  const std::vector<glm::vec3> numbers = randomNumbers(kSurfaceSamples, 301),
                               coins = randomNumbers(kSurfaceSamples, 302), lattice = latticeNumbers(50000);
  cases.forEach([&](const Case& c) {
    const std::vector<Scattered> samples = scattered(leaves, c.material, c.wo, numbers, c.outside);
    std::vector<double> observed, expected;
    dvec3 albedo(0);
    for (const Half& half : halvesOf(c)) {
      const std::vector<ScatterValue> values = half.values(leaves);
      append(half.expected(values), expected);
      append(half.observed(samples, coins), observed);
      albedo += half.albedo(values);
    }
    checkDensity(observed, expected);
    checkWeight(meanWeight(scattered(leaves, c.material, c.wo, lattice, c.outside)), albedo);
  });
}
