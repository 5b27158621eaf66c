// gears: cubes of meshing gears, some of glass, on a mirroring floor. Their faces are concave 144-gons.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

constexpr std::uint32_t kTeeth = 36;
constexpr double kOuterRatio = 0.995;  ///< ratio of the radius to the pitch of the gears, which leaves small gaps
constexpr double kToothDepth = 0.1;    ///< fraction of the radius

using Outline = std::array<glm::dvec3, 4 * kTeeth>;

struct Gear {
  glm::dvec3 centre;  ///< centre of the upper face
  double radius;      ///< radius including the teeth
  double thickness;
  double angle;  ///< angle of the first tooth, radians
};

/// Writes a face: four vertices per tooth, counter-clockwise seen from above (`turn` 1) or below (-1).
Outline outline(const Gear& gear, double z, double turn) {
  constexpr double kToothAngle = 2 * std::numbers::pi / kTeeth;
  constexpr std::array<double, 4> kShares{-0.19, 0.19, 0.3, 0.7};  // of a tooth's angle: two outer, two inner vertices
  const std::array<double, 2> radii{kOuterRatio * gear.radius, (1 - kToothDepth) * gear.radius};
  Outline vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double tooth = gear.angle + turn * 2 * std::numbers::pi * static_cast<double>(i / 4) / kTeeth;
    const double angle = tooth + kShares[i % 4] * turn * kToothAngle;
    const double radius = radii[i % 4 / 2];
    vertices[i] = glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z) + gear.centre;
  }
  return vertices;
}

void writeGear(NffWriter& out, const Gear& gear) {
  const Outline top = outline(gear, 0, 1);
  const glm::dvec3 down(0, 0, -gear.thickness);
  out.polygon(top);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const glm::dvec3& next = top[(i + 1) % top.size()];
    out.polygon(std::array{top[i], top[i] + down, next + down, next});
  }
  out.polygon(outline(gear, -gear.thickness, -1));
}

/// Returns a colour whose brightest channel is 1.
glm::dvec3 colourOf(const glm::uvec3& place) {
  const auto channel = [](std::uint32_t number, double step) { return 0.01 + glm::fract(number * step / 7); };
  const auto [x, y, z] = std::array{place.x, place.y, place.z};
  const glm::dvec3 colour(channel(x * 3 + y * 2 + z + 1, 5), channel(y * 3 + z * 2 + x + 1, 3),
                          channel(z * 3 + x * 2 + y + 1, 2));
  return colour / std::max({colour.x, colour.y, colour.z});
}

Surface surfaceOf(const glm::uvec3& place) {
  const bool isGlass = (place.x * 4 + place.y * 2 + place.z) % 5 == 0;
  if (isGlass) return {colourOf(place), 0.2, 0, 0, 0.8, 1.1};
  return {colourOf(place), 1, 0, 0, 0, 0};
}

void writeFloorAndLights(NffWriter& out) {
  out.background(kSkyBlue);
  out.view({{-1.1, -2.1, 2.6}, {0, 0, 0}, {0, 0, 1}, 45, 1});
  out.light({2, 4, 4});
  out.light({-2, 4, 3});
  out.light({2, -2.5, 2.5});
  out.light({-1, -4, 2});
  out.light({-1.111, -2.121, 2.626});
  out.surface({{1, 0.85, 0.7}, 0.3, 0.6, 37, 0, 0});
  out.square(2, 0);
}

}  // namespace

std::uint64_t gearsPrimitives(std::uint32_t size) {
  const std::uint64_t s = size;
  return 2 + s * s * s * (2 * (4 * kTeeth - 2) + 2 * 4 * kTeeth);
}

void writeGears(NffWriter& out, std::uint32_t size) {
  writeFloorAndLights(out);
  const double s = size;
  const double radius = 1 / (s - (s - 1) * kToothDepth / 2);
  const glm::dvec3 first(-1 + radius, -1 + radius, 1);
  const glm::dvec3 step(radius * (2 - kToothDepth), radius * (2 - kToothDepth), -1 / s);
  const double thickness = std::min(0.1, 1 / (2 * s));
  for (std::uint32_t z = 0; z < size; ++z) {
    for (std::uint32_t y = 0; y < size; ++y) {
      for (std::uint32_t x = 0; x < size; ++x) {
        const glm::uvec3 place(x, y, z);
        const double angle = (x + y + z) % 2 == 0 ? 0 : std::numbers::pi / kTeeth;  // teeth meet gaps
        out.surface(surfaceOf(place));
        writeGear(out, {first + glm::dvec3(place) * step, radius, thickness, angle});
      }
    }
  }
}

}  // namespace candela::generate
