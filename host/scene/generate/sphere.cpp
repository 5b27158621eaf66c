// sphere: a bumpy sphere as one mesh in a closed diffuse room with a light, so that no path escapes.
#include <array>
#include <utility>

#include "host/scene/generate/cube_sphere.h"
#include "host/scene/generate/databases.h"
#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

constexpr glm::dvec3 kCentre{0, 0, 1.8};
constexpr double kMinRadius = 1;
constexpr double kRelief = 0.6;
constexpr double kFrequency = 2;  ///< frequency of the bumps, in wavelengths per radian
constexpr std::uint32_t kReliefOctaves = 5;

/// The room, and the light in its ceiling.
constexpr glm::dvec3 kLow{-2.5, -5, 0};
constexpr glm::dvec3 kHigh{2.5, 2.5, 4.5};
constexpr glm::dvec3 kLampMiddle{0, -1, kHigh.z};
constexpr double kLampHalfWidth = 0.9;
constexpr glm::dvec3 kRadiance{10};

/// Returns the point of the bumpy sphere in a direction from its centre.
glm::dvec3 bumpyPoint(const glm::dvec3& direction) {
  return kCentre + direction * (kMinRadius + kRelief * fractalNoise(direction * kFrequency, kReliefOctaves));
}

/// Returns the four corners of the room on the side of a face, counter-clockwise seen from inside.
std::array<glm::dvec3, 4> wall(const CubeFace& face) {
  const glm::dvec3& origin = face.side > 0 ? kHigh : kLow;
  const glm::dvec3 extent = (kHigh - kLow) * -face.side;
  glm::dvec3 u(0);
  glm::dvec3 v(0);
  u[face.u()] = extent[face.u()];
  v[face.v()] = extent[face.v()];
  if (face.side > 0) std::swap(u, v);
  return {origin, origin + u, origin + u + v, origin + v};
}

/// Writes a frame around the light that closes the ceiling: no light reaches the space above.
void writeCeilingWithLamp(NffWriter& out) {
  const std::array<glm::dvec3, 4> outer = wall({2, 1});
  std::array<glm::dvec3, 4> inner;
  for (std::size_t i = 0; i < 4; ++i) inner[i] = kLampMiddle + kLampHalfWidth * glm::sign(outer[i] - kLampMiddle);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    out.polygon(std::array{outer[i], outer[next], inner[next], inner[i]});
  }
  out.areaLight(inner[0], inner[1] - inner[0], inner[3] - inner[0], kRadiance);
}

void writeRoom(NffWriter& out) {
  static constexpr std::array<glm::dvec3, 5> kColours{
      {{0.25, 0.55, 0.25}, {0.6, 0.25, 0.2}, {0.75, 0.75, 0.75}, {0.75, 0.75, 0.75}, {0.6, 0.6, 0.6}}};
  static constexpr std::array<CubeFace, 5> kWallsAndFloor{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, -1}}};
  for (std::size_t i = 0; i < kWallsAndFloor.size(); ++i) {
    out.surface({kColours[i], 1, 0, 0, 0, 1});
    out.polygon(wall(kWallsAndFloor[i]));
  }
  out.surface({{0.8, 0.8, 0.8}, 1, 0, 0, 0, 1});
  writeCeilingWithLamp(out);
}

}  // namespace

std::uint64_t spherePrimitives(std::uint32_t size) {
  constexpr std::uint64_t kRoomAndLamp = 5 * 2 + 4 * 2 + 2;
  return 12 * std::uint64_t{size} * size + kRoomAndLamp;
}

void writeSphere(NffWriter& out, std::uint32_t size) {
  out.background({0, 0, 0});
  out.view({{0, -4.8, 2.2}, {0, 0, 1.8}, {0, 0, 1}, 45, 0});
  writeRoom(out);
  out.surface({{0.75, 0.7, 0.6}, 1, 0, 0, 0, 1});
  writeCubeSphere(out, size, bumpyPoint);
}

}  // namespace candela::generate
