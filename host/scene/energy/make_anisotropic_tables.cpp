// Writes the C++ source of the tables of anisotropic microfacets: candela_make_anisotropic_tables FILE
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/scene/energy/anisotropic_albedo.h"
#include "host/scene/energy/anisotropic_tables.h"
#include "host/scene/energy/energy_tables.h"
#include "host/scene/energy/quadrature.h"
#include "host/scene/energy/table_grid.h"

namespace {

using namespace candela::energy;

const Lattice kFine(2584, 1597);
const Lattice kCoarse(987, 610);  // of glass, whose interpolation has larger errors

/// Fractions of the way from the first to the last node of the cosines, azimuths, roughnesses and strengths.
using Fractions = std::array<double, 4>;

// The light that microfacets scatter at a point of the tables.
struct Scattering {
  double cosine;
  glm::dvec2 alpha;
  VisibleNormals normals;
};

Scattering scatteringAt(const Fractions& fractions, bool scaledAlongWo, const Lattice& lattice) {
  const double along = std::pow(std::max(fractions[2], kMinRoughness), 2);
  const double across = std::lerp(along, 1.0, fractions[3] * fractions[3]);
  const double part = fractions[1] * fractions[1], towards = std::lerp(along, across, part);
  const double cosine = cosineAt(fractions[0], scaledAlongWo ? towards : across);
  const glm::dvec2 alpha(across, along);
  return {cosine, alpha, VisibleNormals(cosine, part * (towards + along) / (across + along), alpha, lattice)};
}

double whiteAt(const Fractions& fractions) { return scatteringAt(fractions, true, kFine).normals.albedo().white; }

// Returns the opposite of a node of kAnisotropicTilt, which is to be raised as those of kAnisotropicWhite are.
double riseAt(const Fractions& fractions) {
  const Scattering scattering = scatteringAt(fractions, false, kFine);
  const auto [white, grazing] = scattering.normals.albedo();
  return (std::pow(grazing / white, 0.2) - 1 + scattering.cosine) / scattering.alpha.x;
}

std::vector<double> raisedNodes(double (*quantity)(const Fractions&)) {
  const TableGrid<4> grid({kAnisotropicCosines, kAnisotropicAzimuths, kAnisotropicRoughnesses, kAnisotropicStrengths});
  std::vector<double> nodes(grid.size());
  std::vector<TableGrid<4>::Probe> probes;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    nodes[n] = quantity(grid.pointIn(n));
    if (!grid.beginsCell(n)) continue;
    constexpr Fractions kCentre{0.5, 0.5, 0.5, 0.5};
    probes.push_back({n, kCentre, quantity(grid.pointIn(n, kCentre))});
  }
  return grid.raised(nodes, probes);
}

// The boundaries of the glass tables, `part` of the way from their nodes to the next ones.
Boundaries<float> anisotropicBoundaries(bool outside, double part) {
  Boundaries<float> boundaries;
  for (std::size_t m = 0; m < kAnisotropicGlassIors; ++m) {
    const double position = (static_cast<double>(m) + part) / (kAnisotropicGlassIors - 1),
                 root = position * position / 2;
    boundaries.add(std::max((1 + root) / (1 - root), kMinVolumeIor), outside);
  }
  return boundaries;
}

// Computes the glass tables from outside and from inside. All indices of refraction share the microfacets.
class AnisotropicGlass {
 public:
  AnisotropicGlass() {
    const Point steps = quasirandomSteps<5>();
    Point point{0.5, 0.5, 0.5, 0.5, 0.5};
    for (std::size_t node = 0; node < kPlane; ++node) {
      addNodes(node);
      if (!grid_.beginsCell(node)) continue;
      for (std::size_t i = 0; i < kProbesOfCell; ++i) {
        addProbes(node, point);
        for (std::size_t d = 0; d < 5; ++d) point[d] = std::fmod(point[d] + steps[d], 1);
      }
    }
  }

  std::vector<double> nodes(std::size_t side) const { return grid_.raised(nodes_[side], probes_[side]); }

 private:
  using Point = TableGrid<5>::Point;
  using Albedos = std::array<double, kAnisotropicGlassIors>;

  static constexpr std::size_t kProbesOfCell = 4;
  static constexpr std::size_t kSize = std::tuple_size_v<AnisotropicGlassTable>, kPlane = kSize / kAnisotropicGlassIors;

  // Returns the albedos at all indices of refraction from each side, in a cell of the other dimensions.
  std::array<Albedos, 2> albedosIn(std::size_t node, const Point& point) const {
    const Point at = grid_.pointIn(node, point);
    const Scattering scattering = scatteringAt({at[0], at[1], at[2], at[3]}, true, kCoarse);
    std::array<Albedos, 2> sides;
    for (std::size_t side = 0; side < 2; ++side) {
      scattering.normals.integrateGlass(anisotropicBoundaries(side == 0, point[4]), sides[side]);
    }
    return sides;
  }
  void addNodes(std::size_t node) {
    const std::array<Albedos, 2> sides = albedosIn(node, {});
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t m = 0; m < kAnisotropicGlassIors; ++m) nodes_[side][m * kPlane + node] = sides[side][m];
    }
  }
  void addProbes(std::size_t node, const Point& point) {
    const std::array<Albedos, 2> sides = albedosIn(node, point);
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t m = 0; m + 1 < kAnisotropicGlassIors; ++m) {
        probes_[side].push_back({m * kPlane + node, point, sides[side][m]});
      }
    }
  }

  TableGrid<5> grid_{{kAnisotropicGlassCosines, kAnisotropicGlassAzimuths, kAnisotropicGlassRoughnesses,
                      kAnisotropicGlassStrengths, kAnisotropicGlassIors}};
  std::array<std::vector<double>, 2> nodes_{std::vector<double>(kSize), std::vector<double>(kSize)};
  std::array<std::vector<TableGrid<5>::Probe>, 2> probes_;
};

std::string sourceOf(const char* name, const char* type, const std::vector<double>& nodes, double factor) {
  std::string text = fmt::format("const {} {}{{\n", type, name);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    text += fmt::format("{:.6e}f{}", factor * nodes[n], (n + 1) % kAnisotropicCosines == 0 ? ",\n" : ",");
  }
  return text + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: candela_make_anisotropic_tables FILE\n", stderr);
    return 1;
  }
  std::ofstream file(argv[1]);
  file << "#include \"host/scene/energy/anisotropic_tables.h\"\n\nnamespace candela::energy {\n\n";
  file << sourceOf("kAnisotropicWhite", "AnisotropicTable", raisedNodes(whiteAt), kQuadratureMargin);
  file << sourceOf("kAnisotropicTilt", "AnisotropicTable", raisedNodes(riseAt), -1);
  const AnisotropicGlass glass;
  file << sourceOf("kAnisotropicGlassOutside", "AnisotropicGlassTable", glass.nodes(0), kQuadratureMargin);
  file << sourceOf("kAnisotropicGlassInside", "AnisotropicGlassTable", glass.nodes(1), kQuadratureMargin);
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
