// Writes the C++ source of the energy tables: candela_make_energy_tables FILE
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "host/energy/energy_tables.h"
#include "host/energy/microfacet_albedo.h"
#include "host/energy/sheen_albedo.h"

namespace {

using candela::energy::kGlassCosines;
using candela::energy::kGlassIors;
using candela::energy::kGlassRoughnesses;
using candela::energy::kMinRoughness;
using candela::energy::kNodes;

constexpr int kRings = 256, kSpokes = 64;
constexpr double kQuadratureMargin = 1.001;  // quadrature of glass is up to 0.12 % too low, at grazing angles

struct Node {
  double white;
  double tilt;
};

double alphaOf(std::size_t j) {
  const double roughness = std::max(static_cast<double>(j) / (kNodes - 1), kMinRoughness);
  return roughness * roughness;
}

// Returns the cosine c at which c (1 + scale) / (c + scale) is x.
double cosineAt(double x, double scale) { return std::min(1.0, scale * x / (1 + scale - x)); }

Node nodeAt(std::size_t i, std::size_t j) {
  const double alpha = alphaOf(j), cosine = cosineAt(static_cast<double>(i) / (kNodes - 1), alpha);
  const auto [white, grazing] = candela::energy::integrateMicrofacets(cosine, alpha, kRings, kSpokes);
  return {white, (1 - cosine - std::pow(grazing / white, 0.2)) / alpha};
}

std::string sourceOf(const char* name, double Node::*member) {
  std::string text = fmt::format("const Table {}{{\n", name);
  for (std::size_t j = 0; j < kNodes; ++j) {
    for (std::size_t i = 0; i < kNodes; ++i) text += fmt::format("{:.9e}f,", nodeAt(i, j).*member);
    text += '\n';
  }
  return text + "};\n";
}

// A plane of a glass table: the albedos at places (i, j) between the nodes of one index of refraction.
class GlassPlane {
 public:
  GlassPlane(std::size_t k, bool outside) : outside_(outside) {
    const double root = static_cast<double>(k) / 2 / (kGlassIors - 1);
    ior_ = std::max((1 + root) / (1 - root), candela::energy::kMinVolumeIor);
  }

  // Returns the nodes, raised until no centre of a cell falls short of its albedo.
  std::vector<double> nodes() const {
    std::vector<double> nodes, shortfall(kGlassCosines * kGlassRoughnesses);
    for (std::size_t n = 0; n < shortfall.size(); ++n) {
      nodes.push_back(albedo(static_cast<double>(n % kGlassCosines), static_cast<double>(n / kGlassCosines)));
    }
    for (std::size_t j = 0; j + 1 < kGlassRoughnesses; ++j) {
      for (std::size_t i = 0; i + 1 < kGlassCosines; ++i) {
        const std::size_t first = j * kGlassCosines + i;
        const std::array corners{first, first + 1, first + kGlassCosines, first + kGlassCosines + 1};
        double centre = 0;
        for (const std::size_t corner : corners) centre += nodes[corner] / 4;
        const double missing = albedo(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5) - centre;
        for (const std::size_t corner : corners) shortfall[corner] = std::max(shortfall[corner], missing);
      }
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = kQuadratureMargin * (nodes[n] + shortfall[n]);
    return nodes;
  }

 private:
  double albedo(double i, double j) const {
    const double roughness = std::max(j / (kGlassRoughnesses - 1), kMinRoughness), alpha = roughness * roughness;
    return candela::energy::integrateGlass(cosineAt(i / (kGlassCosines - 1), alpha), alpha, ior_, outside_);
  }

  double ior_;
  bool outside_;
};

std::string glassSourceOf(const char* name, bool outside) {
  std::string text = fmt::format("const GlassTable {}{{\n", name);
  for (std::size_t k = 0; k < kGlassIors; ++k) {
    for (const double node : GlassPlane(k, outside).nodes()) text += fmt::format("{:.9e}f,", node);
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
  file << "#include \"host/energy/energy_tables.h\"\n\nnamespace candela::energy {\n\n";
  file << sourceOf("kWhite", &Node::white) << sourceOf("kTilt", &Node::tilt);
  file << glassSourceOf("kGlassOutside", true) << glassSourceOf("kGlassInside", false);
  file << sheenSource();
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
