// The chi-square test of a surface's samples.
#pragma once
#include "tests/trace/proof/surface_cells.h"

namespace candela::proof {

/// Random numbers that all cases of a test take.
struct SurfaceNumbers {
  std::vector<glm::vec3> samples;
  std::vector<glm::vec3> coins;  ///< that choose between cells
  std::vector<glm::vec3> lattice;

  SurfaceNumbers();
};

/// Fails the running test case unless the surface's samples have the stated density, and their mean weight is the
/// albedo by quadrature.
void checkSurface(const MaterialLeaves& leaves, const SurfaceCase& c, const SurfaceNumbers& numbers);

}  // namespace candela::proof
