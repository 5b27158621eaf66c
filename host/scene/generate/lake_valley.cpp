// The height of the ground by sums of noise, and its mesh, which is finer near the lake.
#include "host/scene/generate/lake_valley.h"

#include <algorithm>
#include <cmath>

#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr dvec2 kLakeCentre{8, -92}, kLakeRadii{66, 58};
constexpr double kFineReach = 130;  // of the part of the grid with equal cells
constexpr double kFineCell = 3.2;
constexpr double kGrowth = 1.04;  // of the cells beyond
constexpr dvec2 kMapLow{-1700, -3000}, kMapHigh{1700, 700};

double noiseAt(const dvec2& place, double wavelength, std::uint32_t octaves) {
  return fractalNoise({place / wavelength, 0.37 * wavelength}, octaves);
}

// Returns the height of distant mountains with ridges.
double mountain(const dvec2& place) {
  const double ridge = 1 - std::abs(2 * noiseAt(place, 620, 5) - 1);
  return smoothStep(600, 2300, length(place - kLakeCentre)) * (30 + 430 * ridge * ridge * ridge);
}

double heightOfGround(const dvec2& place) {
  const double shore = LakeValley::shoreDistance(place);
  if (shore < 0) return std::max(-5.0, 0.3 * shore);
  const double bank = 0.8 * (1 - std::exp(-shore / 5)) + 0.045 * std::min(shore, 80.0);
  const double middle = 70 * std::sin(place.y / 330);  // of the valley
  const double side = std::abs(place.x - middle);
  const double hills = 62 * smoothStep(45, 380, side) + 45 * smoothStep(190, 900, -place.y) +
                       26 * noiseAt(place, 120, 5) * smoothStep(60, 260, length(place - kLakeCentre)) +
                       5 * noiseAt(place, 38, 4);
  return bank + smoothStep(4, 110, shore) * (hills + mountain(place));
}

// Returns the coordinates of grid lines from `low` to `high`.
std::vector<double> gridLines(double low, double centre, double high) {
  std::vector<double> lines;
  const auto extend = [&](double end, double sign) {
    double distance = 0, cell = kFineCell;
    while (sign * (end - centre) > distance) {
      distance += cell;
      if (distance > kFineReach) cell *= kGrowth;
      lines.push_back(centre + sign * distance);
    }
  };
  extend(low, -1);
  std::ranges::reverse(lines);
  lines.push_back(centre);
  extend(high, 1);
  return lines;
}

// Returns the index of the cell that contains a coordinate.
std::size_t cellOf(const std::vector<double>& lines, double x) {
  const auto after = std::ranges::upper_bound(lines, x) - lines.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(lines) - 2));
}

dvec3 colourOfGround(const dvec2& place, double height, double slope) {
  const double shore = LakeValley::shoreDistance(place);
  const double patches = noiseAt(place, 14, 4), wide = noiseAt(place, 55, 3);
  const dvec3 grass = mix(dvec3(0.075, 0.115, 0.025), dvec3(0.19, 0.18, 0.055), smoothStep(0.3, 0.7, patches));
  const dvec3 floor = mix(dvec3(0.075, 0.07, 0.03), dvec3(0.15, 0.1, 0.04), smoothStep(0.35, 0.65, wide));
  const dvec3 beach = mix(dvec3(0.2, 0.17, 0.12), dvec3(0.12, 0.105, 0.075), patches);
  const dvec3 rock = mix(dvec3(0.22, 0.21, 0.2), dvec3(0.33, 0.31, 0.29), patches);
  const dvec3 distant = mix(dvec3(0.018, 0.034, 0.016), dvec3(0.06, 0.06, 0.02), smoothStep(0.35, 0.7, wide));
  dvec3 colour = mix(grass, floor, smoothStep(25, 60, length(place)));
  colour = mix(colour, distant, smoothStep(100, 300, length(place)));
  const double snow = smoothStep(240, 330, height + 130 * wide - 60 * slope) * smoothStep(1.15, 0.8, slope);
  colour = mix(colour, rock, smoothStep(0.55, 0.9, slope + 0.3 * patches));
  colour = mix(colour, dvec3(0.75, 0.78, 0.82), snow);
  colour = mix(beach, colour, smoothStep(0.3, 2.5, shore + 3 * (patches - 0.5)));
  const double haze = 1 - std::exp(-length(place) / 6000);
  return mix(colour, dvec3(0.36, 0.46, 0.58), haze);
}

}  // namespace

double LakeValley::shoreDistance(const dvec2& place) {
  const dvec2 relative = (place - kLakeCentre) / kLakeRadii;
  const double bays = 0.55 * (noiseAt(place, 48, 3) - 0.5);
  return (length(relative) - 1 + bays) * std::min(kLakeRadii.x, kLakeRadii.y);
}

LakeValley::LakeValley()
    : columns_(gridLines(kMapLow.x, kLakeCentre.x, kMapHigh.x)), rows_(gridLines(kMapLow.y, -60, kMapHigh.y)) {
  for (const double z : rows_) {
    for (const double x : columns_) heights_.push_back(heightOfGround({x, z}));
  }
}

double LakeValley::heightAt(const dvec2& place) const {
  const std::size_t i = cellOf(columns_, place.x), k = cellOf(rows_, place.y);
  const double u = (place.x - columns_[i]) / (columns_[i + 1] - columns_[i]);
  const double v = (place.y - rows_[k]) / (rows_[k + 1] - rows_[k]);
  const double a = heightOf(i, k), b = heightOf(i + 1, k), c = heightOf(i + 1, k + 1), d = heightOf(i, k + 1);
  // The diagonal of a cell goes from a to c.
  return u > v ? a + u * (b - a) + v * (c - b) : a + v * (d - a) + u * (c - d);
}

double LakeValley::slopeAt(const dvec2& place) const {
  constexpr double kStep = 2;
  const dvec2 dx(kStep, 0), dz(0, kStep);
  return length(dvec2(heightAt(place + dx) - heightAt(place - dx), heightAt(place + dz) - heightAt(place - dz))) /
         (2 * kStep);
}

bool LakeValley::contains(const dvec2& place) const {
  return place.x > columns_.front() && place.x < columns_.back() && place.y > rows_.front() && place.y < rows_.back();
}

TriangleMesh LakeValley::groundMesh() const {
  TriangleMesh mesh;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::size_t west = i == 0 ? 0 : i - 1, east = std::min(i + 1, columns_.size() - 1);
      const std::size_t north = k == 0 ? 0 : k - 1, south = std::min(k + 1, rows_.size() - 1);
      const dvec2 slope((heightOf(east, k) - heightOf(west, k)) / (columns_[east] - columns_[west]),
                        (heightOf(i, south) - heightOf(i, north)) / (rows_[south] - rows_[north]));
      const dvec2 place(columns_[i], rows_[k]);
      mesh.positions.emplace_back(place.x, heightOf(i, k), place.y);
      mesh.normals.emplace_back(normalize(dvec3(-slope.x, 1, -slope.y)));
      mesh.colours.emplace_back(colourOfGround(place, heightOf(i, k), length(slope)));
    }
  }
  const auto width = static_cast<std::uint32_t>(columns_.size());
  for (std::uint32_t k = 0; k + 1 < rows_.size(); ++k) {
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = k * width + i, d = a + width;
      mesh.indices.insert(mesh.indices.end(), {a, d + 1, a + 1, a, d, d + 1});
    }
  }
  return mesh;
}

TriangleMesh LakeValley::waterMesh() {
  constexpr std::uint32_t kSide = 90;
  constexpr double kMargin = 1.75, kSteepness = 0.012;
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k <= kSide; ++k) {
    for (std::uint32_t i = 0; i <= kSide; ++i) {
      const dvec2 place = kLakeCentre + kMargin * kLakeRadii * (dvec2(i, k) * (2.0 / kSide) - 1.0);
      const dvec2 slope = kSteepness * (dvec2(noiseAt(place, 7, 2), noiseAt(place + 500.0, 5, 2)) * 2.0 - 1.0);
      mesh.positions.emplace_back(place.x, 0, place.y);
      mesh.normals.emplace_back(normalize(dvec3(slope.x, 1, slope.y)));
      if (i == kSide || k == kSide) continue;
      const std::uint32_t a = k * (kSide + 1) + i, d = a + kSide + 1;
      mesh.indices.insert(mesh.indices.end(), {a, d, d + 1, a, d + 1, a + 1});
    }
  }
  return mesh;
}

}  // namespace candela::generate
