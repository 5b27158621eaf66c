// Boundaries between dielectrics: docs/light-transport.md section 5.5.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace candela::energy {

/// Boundaries as parallel arrays, so that compilers vectorise loops over them.
template <typename Real>
struct Boundaries {
  std::vector<Real> eta;                ///< index of refraction on the side of wo divided by the other
  std::vector<Real> normalReflectance;  ///< at normal incidence

  std::size_t size() const { return eta.size(); }
  /// `ior` > 1 is the index inside; `outside`: wo is outside.
  void add(double ior, bool outside) {
    eta.push_back(static_cast<Real>(outside ? 1 / ior : ior));
    normalReflectance.push_back(static_cast<Real>(std::pow((ior - 1) / (ior + 1), 2)));
  }
};

}  // namespace candela::energy
