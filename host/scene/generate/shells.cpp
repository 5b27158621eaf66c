// shells: a shell of spheres along a spiral (C. Pickover, IEEE CG&A 9(6), 1989). They all overlap, and their radii
// range over four decades, which is the worst case for grids.
#include <cmath>
#include <numbers>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

std::uint64_t steps(std::uint32_t size) { return std::uint64_t{180} << size; }

}  // namespace

std::uint64_t shellsPrimitives(std::uint32_t size) { return steps(size) + 1; }

void writeShells(NffWriter& out, std::uint32_t size) {
  constexpr double kTurns = 9;
  constexpr double kGrowth = 0.15;  // growth of the logarithm of the radius per radian
  constexpr double kPitch = -2;     // height, as a multiple of the radius
  out.background(kSkyBlue);
  out.view({{-6, -60, 35}, {0, 8, -15}, {0, 0, 1}, 45, 0.5});
  out.light({-100, -100, 100});
  out.surface({{1, 0.8, 0.4}, 0.8, 0.2, 10, 0, 1});
  const auto count = static_cast<double>(steps(size));
  // Two thirds of the spiral lie within the radius 1.
  for (std::uint64_t i = 0; i <= steps(size); ++i) {
    const double angle = kTurns * 2 * std::numbers::pi * (static_cast<double>(i) - count * 2 / 3) / count;
    const double radius = std::exp(kGrowth * angle);
    out.sphere({radius * std::sin(angle), radius * std::cos(angle), kPitch * radius}, radius);
  }
}

}  // namespace candela::generate
