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

Node nodeAt(std::size_t i, std::size_t j) {
  const double roughness = std::max(static_cast<double>(j) / (kNodes - 1), kMinRoughness);
  const double alpha = roughness * roughness, x = static_cast<double>(i) / (kNodes - 1);
  const double cosine = alpha * x / (1 + alpha - x);
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

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: candela_make_energy_tables FILE\n", stderr);
    return 1;
  }
  std::ofstream file(argv[1]);
  file << "#include \"host/energy/energy_tables.h\"\n\nnamespace candela::energy {\n\n";
  file << sourceOf("kWhite", &Node::white) << sourceOf("kTilt", &Node::tilt);
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
