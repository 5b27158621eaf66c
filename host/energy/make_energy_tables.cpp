// Writes the C++ source of the energy tables: candela_make_energy_tables FILE
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "host/energy/energy_tables.h"
#include "host/energy/microfacet_albedo.h"

namespace {

using candela::energy::kMinRoughness;
using candela::energy::kNodes;

constexpr int kRings = 256, kSpokes = 64;

struct Node {
  double white;
  double tilt;
};

double alphaOf(std::size_t j, std::size_t nodes) {
  const double roughness = std::max(static_cast<double>(j) / static_cast<double>(nodes - 1), kMinRoughness);
  return roughness * roughness;
}

double cosineOf(std::size_t i, std::size_t nodes, double alpha) {
  const double x = static_cast<double>(i) / static_cast<double>(nodes - 1);
  return std::min(1.0, alpha * x / (1 + alpha - x));
}

Node nodeAt(std::size_t i, std::size_t j) {
  const double alpha = alphaOf(j, kNodes), cosine = cosineOf(i, kNodes, alpha);
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

double glassAt(std::size_t i, std::size_t j, std::size_t k, bool outside) {
  using namespace candela::energy;
  const double root = static_cast<double>(k) / 2 / (kGlassIors - 1);
  const double ior = std::max((1 + root) / (1 - root), kMinVolumeIor);
  const double alpha = alphaOf(j, kGlassRoughnesses);
  return kGlassMargin * integrateGlass(cosineOf(i, kGlassCosines, alpha), alpha, ior, outside);
}

std::string glassSourceOf(const char* name, bool outside) {
  using namespace candela::energy;
  std::string text = fmt::format("const GlassTable {}{{\n", name);
  for (std::size_t k = 0; k < kGlassIors; ++k) {
    for (std::size_t j = 0; j < kGlassRoughnesses; ++j) {
      for (std::size_t i = 0; i < kGlassCosines; ++i) text += fmt::format("{:.9e}f,", glassAt(i, j, k, outside));
      text += '\n';
    }
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
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
