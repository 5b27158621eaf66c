// Cells and quadrature over the directions to which a surface scatters light.
#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/hemisphere.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/slope_grid.h"

namespace candela::proof {

constexpr std::size_t kSurfaceSamples = 100000;
constexpr int kCellRows = 24, kCellColumns = 24;
constexpr double kNarrow = 0.3;  ///< up to this roughness, cells follow the highlight

/// A surface that is seen from one direction.
struct SurfaceCase {
  std::uint32_t material;
  scene::SurfaceParameters surface;
  dvec3 wo;
  bool outside = true;
  dvec3 geometric{0};  ///< as in DirectionPair; such surfaces must not be narrow

  Passage transmission() const { return surface.isThinWalled ? Passage::thin : Passage::refracted; }
  double eta() const { return outside ? surface.ior : 1 / double{surface.ior}; }

  bool hasNarrowCoat() const { return surface.coatWeight > 0 && surface.coatRoughness < kNarrow; }
  /// Returns alpha of the highlight that cells follow: that of a coat, whose base must not be narrow, or of the base.
  std::optional<dvec2> highlight() const {
    if (hasNarrowCoat()) return dvec2(std::pow(double{surface.coatRoughness}, 2));
    const bool exists = surface.metalness > 0 || surface.specularWeight > 0;
    if (!exists || surface.roughness >= kNarrow) return std::nullopt;
    const double alpha = std::pow(double{surface.roughness}, 2), strength = surface.anisotropy;
    return dvec2(std::lerp(alpha, 1.0, strength * strength), alpha);
  }

  /// The frame of the geometric normal, in which cells are.
  dvec3 local(const dvec3& w) const {
    return geometric == dvec3(0) ? w : dvec3(dot(w, across()), dot(w, along()), dot(w, geometric));
  }
  dvec3 fromLocal(const dvec3& w) const {
    return geometric == dvec3(0) ? w : w.x * across() + w.y * along() + w.z * geometric;
  }

 private:
  dvec3 across() const { return normalize(cross(dvec3(0, 1, 0), geometric)); }
  dvec3 along() const { return cross(geometric, across()); }
};

/// The cells of one side of a surface, and quadrature over them. Cells that follow the highlight resolve narrow lobes,
/// those of the hemisphere broad lobes: in the cells of a long and narrow highlight, a broad lobe fills only a narrow
/// range of azimuths. Where a surface may have both, a direction belongs to the former with a probability that falls
/// smoothly with the density of their quadrature, so that each kind of cells integrates the densities that it resolves.
class Half {
 public:
  Half(const SurfaceCase& c, bool transmitted) : case_(c), transmitted_(transmitted) {
    if (const std::optional<dvec2> alpha = c.highlight(); alpha && !(transmitted && c.hasNarrowCoat())) {
      slopes_.emplace(hasBoth() ? fineNodes() : nodes(), c.wo, *alpha,
                      transmitted ? c.transmission() : Passage::reflected, c.eta());
      addSlopes();
    }
    if (!slopes_ || hasBoth()) addHemisphere();
  }

  bool contains(const dvec3& wi) const { return (case_.local(wi).z < 0) == transmitted_; }
  const std::vector<QuadraturePoint>& points() const { return points_; }
  std::vector<ScatterValue> values(const MaterialLeaves& leaves) const {
    std::vector<DirectionPair> pairs;
    for (const QuadraturePoint& point : points_) {
      pairs.push_back({case_.material, case_.wo, point.direction, case_.outside, {}, case_.geometric});
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
      sum += values[i].f * (std::abs(case_.local(points_[i].direction).z) * points_[i].solidAngle);
    }
    return sum;
  }

  /// Counts samples in all cells. `coins` in [0, 1) choose between the cells.
  std::vector<double> observed(std::span<const Scattered> samples, std::span<const glm::vec3> coins) const {
    Cells highlight(kCellRows, kCellColumns), hemisphere(kCellRows, kCellColumns);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const dvec3& wi = samples[i].wi;
      if (samples[i].lobe == render::Lobe::none || !contains(wi)) continue;
      if (coins[i].x < highlightFraction(wi)) {
        highlight.add(slopes_->placeOf(wi));
        continue;
      }
      const dvec3 local = case_.local(wi);
      hemisphere.add({std::abs(local.z), turns(local.x, local.y)});
    }
    return joined(highlight, hemisphere);
  }

 private:
  bool hasBoth() const { return case_.surface.anisotropy > 0 || case_.hasNarrowCoat(); }

  static std::span<const QuadraturePoint> nodes() {
    static const HemisphereGrid grid(kCellRows, 2 * kCellColumns);
    return grid.points();
  }
  // The horizon cuts highlights beside broad lobes: many cells with few points integrate densities that are not smooth.
  static std::span<const QuadraturePoint> fineNodes() {
    static const GaussGrid<3> grid(8 * kCellRows, 8 * kCellColumns);
    return grid.points();
  }

  // Returns the probability with which a direction belongs to the cells of the highlight.
  double highlightFraction(const dvec3& wi) const {
    if (!slopes_ || !hasBoth()) return slopes_ ? 1 : 0;
    const double ratio = slopes_->spreadAt(wi) / (2 * std::numbers::pi);
    return 1 / (1 + ratio * ratio);
  }

  void addSlopes() {
    points_ = slopes_->points();
    highlightPoints_ = points_.size();
    for (QuadraturePoint& point : points_) point.solidAngle *= highlightFraction(point.direction);
  }

  void addHemisphere() {
    const HemisphereGrid hemisphere(2 * kCellRows, 2 * kCellColumns);
    for (QuadraturePoint point : hemisphere.points()) {
      if (transmitted_) point.direction.z = -point.direction.z;
      point.direction = case_.fromLocal(point.direction);
      point.solidAngle *= 1 - highlightFraction(point.direction);
      points_.push_back(point);
    }
  }

  static std::vector<double> joined(const Cells& first, const Cells& second) {
    std::vector<double> counts = first.counts();
    counts.insert(counts.end(), second.counts().begin(), second.counts().end());
    return counts;
  }

  SurfaceCase case_;
  bool transmitted_;
  std::optional<SlopeGrid> slopes_;
  std::vector<QuadraturePoint> points_;  // first those of the highlight
  std::size_t highlightPoints_ = 0;
};

/// Returns the sides of a surface to which it scatters light.
inline std::vector<Half> halvesOf(const SurfaceCase& c) {
  std::vector<Half> halves{Half(c, false)};
  if (c.surface.transmissionWeight > 0) halves.emplace_back(c, true);
  return halves;
}

}  // namespace candela::proof
