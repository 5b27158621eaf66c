// The energy that anisotropic microfacets scatter once: docs/light-transport.md section 5.12.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "host/scene/energy/boundary.h"
#include "host/scene/energy/microfacet_albedo.h"

namespace candela::energy {

/// Points of a unit square, as parallel arrays: a lattice whose size and step are successive Fibonacci numbers. It is
/// periodic in the azimuth.
struct Lattice {
  std::vector<float> heights, cosines, sines;

  Lattice(std::size_t points, std::size_t step);
  std::size_t size() const { return heights.size(); }
};

/// The normals that a direction wo sees, at the points of a lattice. Its integrals are computed in single precision,
/// whose rounding is small compared with the error of the quadrature: with 2,584 points at most 0.15 %.
class VisibleNormals {
 public:
  /// `cosine` in [0, 1] is that of wo, `cosSquared` the squared cosine of its azimuth to the x axis, `alpha` the
  /// roughness along x and y, in (0, 1].
  VisibleNormals(double cosine, double cosSquared, const glm::dvec2& alpha, const Lattice& lattice);

  MicrofacetAlbedo albedo() const;
  /// Computes, for each of `boundaries`, the fraction of light that glass reflects or transmits to the side where it
  /// belongs. `albedos` has as many elements.
  void integrateGlass(const Boundaries<float>& boundaries, std::span<double> albedos) const;

 private:
  std::size_t size() const { return x_.size(); }
  void addNormals(const Lattice& lattice);
  void addReflected();

  glm::vec2 alpha_;
  glm::vec3 wo_;
  float length_;  // of wo stretched by alpha
  std::vector<float> x_, y_, z_;
  std::vector<float> cosines_;    // between wo and the normal
  std::vector<float> reflected_;  // weight of the direction that it reflects
};

}  // namespace candela::energy
