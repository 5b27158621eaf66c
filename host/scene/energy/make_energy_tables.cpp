// Writes the C++ source of the energy tables: candela_make_energy_tables FILE
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/scene/energy/energy_tables.h"
#include "host/scene/energy/microfacet_albedo.h"
#include "host/scene/energy/quadrature.h"
#include "host/scene/energy/sheen_albedo.h"

namespace {

using candela::energy::cosineAt;
using candela::energy::kGlassCosines;
using candela::energy::kGlassIors;
using candela::energy::kGlassRoughnesses;
using candela::energy::kMinRoughness;
using candela::energy::kNodes;
using candela::energy::kQuadratureMargin;

constexpr int kRings = 256, kSpokes = 64;

struct Node {
  double white;
  double tilt;
};

double alphaOf(std::size_t j) {
  const double roughness = std::max(static_cast<double>(j) / (kNodes - 1), kMinRoughness);
  return roughness * roughness;
}

Node nodeAt(std::size_t i, std::size_t j) {
  const double alpha = alphaOf(j), cosine = cosineAt(static_cast<double>(i) / (kNodes - 1), alpha);
  const auto [white, grazing] = candela::energy::integrateMicrofacets(cosine, alpha, kRings, kSpokes);
  return {white, (1 - cosine - std::pow(grazing / white, 0.2)) / alpha};
}

std::vector<Node> microfacetNodes() {
  std::vector<Node> nodes;
  for (std::size_t n = 0; n < kNodes * kNodes; ++n) nodes.push_back(nodeAt(n % kNodes, n / kNodes));
  return nodes;
}

std::string sourceOf(const char* name, const std::vector<Node>& nodes, double Node::*member) {
  std::string text = fmt::format("const Table {}{{\n", name);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    text += fmt::format("{:.9e}f,{}", nodes[n].*member, (n + 1) % kNodes == 0 ? "\n" : "");
  }
  return text + "};\n";
}

// The albedos of all boundaries at a point between nodes.
using GlassAlbedos = std::array<double, 2 * kGlassIors>;

// The boundaries of all indices of refraction, from outside and then from inside.
candela::energy::Boundaries<double> glassBoundaries() {
  candela::energy::Boundaries<double> boundaries;
  for (const bool outside : {true, false}) {
    for (std::size_t k = 0; k < kGlassIors; ++k) {
      const double root = static_cast<double>(k) / 2 / (kGlassIors - 1);
      boundaries.add(std::max((1 + root) / (1 - root), candela::energy::kMinVolumeIor), outside);
    }
  }
  return boundaries;
}

GlassAlbedos glassAt(double i, double j) {
  static const candela::energy::Boundaries<double> kBoundaries = glassBoundaries();
  const double roughness = std::max(j / (kGlassRoughnesses - 1), kMinRoughness), alpha = roughness * roughness;
  GlassAlbedos albedos;
  candela::energy::integrateGlass(cosineAt(i / (kGlassCosines - 1), alpha), alpha, kBoundaries, albedos);
  return albedos;
}

// Returns the albedos at the nodes, displaced by a part of their distance.
std::vector<GlassAlbedos> glassPlane(std::size_t cosines, std::size_t roughnesses, double part) {
  std::vector<GlassAlbedos> plane;
  for (std::size_t n = 0; n < cosines * roughnesses; ++n) {
    plane.push_back(glassAt(static_cast<double>(n % cosines) + part, static_cast<double>(n / cosines) + part));
  }
  return plane;
}

// The planes of the glass tables, each of one boundary.
class GlassPlanes {
 public:
  // Returns the nodes of a boundary, raised until no centre of a cell falls short of its albedo.
  std::vector<double> nodesOf(std::size_t boundary) const {
    std::vector<double> nodes, shortfall(kGlassCosines * kGlassRoughnesses);
    for (const GlassAlbedos& albedos : nodes_) nodes.push_back(albedos[boundary]);
    for (std::size_t cell = 0; cell < centres_.size(); ++cell) {
      const std::size_t first = cell / kCellCosines * kGlassCosines + cell % kCellCosines;
      const std::array corners{first, first + 1, first + kGlassCosines, first + kGlassCosines + 1};
      double centre = 0;
      for (const std::size_t corner : corners) centre += nodes[corner] / 4;
      const double missing = centres_[cell][boundary] - centre;
      for (const std::size_t corner : corners) shortfall[corner] = std::max(shortfall[corner], missing);
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = kQuadratureMargin * (nodes[n] + shortfall[n]);
    return nodes;
  }

 private:
  static constexpr std::size_t kCellCosines = kGlassCosines - 1;

  std::vector<GlassAlbedos> nodes_ = glassPlane(kGlassCosines, kGlassRoughnesses, 0);
  std::vector<GlassAlbedos> centres_ = glassPlane(kCellCosines, kGlassRoughnesses - 1, 0.5);
};

std::string glassSourceOf(const char* name, const GlassPlanes& planes, std::size_t firstBoundary) {
  std::string text = fmt::format("const GlassTable {}{{\n", name);
  for (std::size_t k = 0; k < kGlassIors; ++k) {
    for (const double node : planes.nodesOf(firstBoundary + k)) text += fmt::format("{:.9e}f,", node);
    text += '\n';
  }
  return text + "};\n";
}

std::string sheenSource() {
  using namespace candela::energy;
  std::string text = "const SheenTable kSheen{\n";
  for (std::size_t j = 0; j < kSheenRoughnesses; ++j) {
    const double roughness = std::max(static_cast<double>(j) / (kSheenRoughnesses - 1), kMinSheenRoughness);
    const double weight = roughness / (0.198 + 0.24 * roughness);
    for (std::size_t i = 0; i < kSheenCosines; ++i) {
      const double root = static_cast<double>(i) / (kSheenCosines - 1);
      const double albedo = integrateSheen(cosineAt(root * root, roughness), roughness * roughness);
      text += fmt::format("{:.9e}f,", weight * albedo);
    }
    text += '\n';
  }
  return text + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: candela_make_energy_tables FILE\n", stderr);
    return 1;
  }
  std::ofstream file(argv[1]);
  file << "#include \"host/scene/energy/energy_tables.h\"\n\nnamespace candela::energy {\n\n";
  const std::vector<Node> nodes = microfacetNodes();
  file << sourceOf("kWhite", nodes, &Node::white) << sourceOf("kTilt", nodes, &Node::tilt);
  const GlassPlanes planes;
  file << glassSourceOf("kGlassOutside", planes, 0) << glassSourceOf("kGlassInside", planes, kGlassIors);
  file << sheenSource();
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
