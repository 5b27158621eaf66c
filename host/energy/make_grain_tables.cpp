// Writes the C++ source of the tables of anisotropic microfacets: candela_make_grain_tables FILE
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "host/energy/energy_tables.h"
#include "host/energy/grain_albedo.h"
#include "host/energy/grain_tables.h"

namespace {

using namespace candela::energy;

constexpr double kQuadratureMargin = 1.001;
constexpr std::array<std::size_t, 4> kSizes{kGrainCosines, kGrainAzimuths, kGrainRoughnesses, kGrainStrengths};

/// Cosine, azimuth, roughness and strength in units of the distance of nodes.
using Place = std::array<double, 4>;

/// The arguments of the integral.
struct Point {
  double cosine, cosSquared;
  glm::dvec2 alpha;
};

// Returns the cosine c at which c (1 + scale) / (c + scale) is x.
double cosineAt(double x, double scale) { return std::min(1.0, scale * x / (1 + scale - x)); }

Point pointAt(const Place& place, bool scaledAlongWo) {
  const auto fraction = [&](std::size_t d) { return place[d] / static_cast<double>(kSizes[d] - 1); };
  const double along = std::pow(std::max(fraction(2), kMinRoughness), 2);
  const double across = std::lerp(along, 1.0, fraction(3) * fraction(3));
  const double part = fraction(1) * fraction(1), towards = std::lerp(along, across, part);
  return {cosineAt(fraction(0), scaledAlongWo ? towards : across),
          part * (towards + along) / (across + along),
          {across, along}};
}

double whiteAt(const Place& place) {
  const Point point = pointAt(place, true);
  return integrateGrain(point.cosine, point.cosSquared, point.alpha).white;
}

// Returns the opposite of a node of kGrainTilt, which is to be raised as those of kGrainWhite are.
double riseAt(const Place& place) {
  const Point point = pointAt(place, false);
  const auto [white, grazing] = integrateGrain(point.cosine, point.cosSquared, point.alpha);
  return (std::pow(grazing / white, 0.2) - 1 + point.cosine) / point.alpha.x;
}

Place placeOf(std::size_t node) {
  Place place{};
  for (std::size_t d = 0; d < 4; ++d) {
    place[d] = static_cast<double>(node % kSizes[d]);
    node /= kSizes[d];
  }
  return place;
}

// Returns the indices of the 16 nodes of the cell that begins at `node`; none if it is on an upper border.
std::vector<std::size_t> cellAt(std::size_t node) {
  std::vector<std::size_t> corners{node};
  std::size_t stride = 1;
  for (std::size_t d = 0; d < 4; ++d) {
    if (node / stride % kSizes[d] + 1 == kSizes[d]) return {};
    for (std::size_t i = 0, count = corners.size(); i < count; ++i) corners.push_back(corners[i] + stride);
    stride *= kSizes[d];
  }
  return corners;
}

// Returns the nodes of a quantity, raised until no centre of a cell falls short of it.
std::vector<double> raisedNodes(const std::function<double(const Place&)>& quantity) {
  std::vector<double> nodes, shortfall(std::tuple_size_v<GrainTable>);
  for (std::size_t n = 0; n < shortfall.size(); ++n) nodes.push_back(quantity(placeOf(n)));
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const std::vector<std::size_t> corners = cellAt(n);
    if (corners.empty()) continue;
    double mean = 0;
    for (const std::size_t corner : corners) mean += nodes[corner] / 16;
    Place centre = placeOf(n);
    for (double& coordinate : centre) coordinate += 0.5;
    const double missing = quantity(centre) - mean;
    for (const std::size_t corner : corners) shortfall[corner] = std::max(shortfall[corner], missing);
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] += shortfall[n];
  return nodes;
}

std::string sourceOf(const char* name, const std::vector<double>& nodes, double factor) {
  std::string text = fmt::format("const GrainTable {}{{\n", name);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    text += fmt::format("{:.6e}f{}", factor * nodes[n], (n + 1) % kGrainCosines == 0 ? ",\n" : ",");
  }
  return text + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: candela_make_grain_tables FILE\n", stderr);
    return 1;
  }
  std::ofstream file(argv[1]);
  file << "#include \"host/energy/grain_tables.h\"\n\nnamespace candela::energy {\n\n";
  file << sourceOf("kGrainWhite", raisedNodes(whiteAt), kQuadratureMargin);
  file << sourceOf("kGrainTilt", raisedNodes(riseAt), -1);
  file << "\n}  // namespace candela::energy\n";
  file.close();
  return file ? 0 : 1;
}
