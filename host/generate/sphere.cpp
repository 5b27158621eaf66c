// sphere: a bumpy sphere as one mesh in a closed diffuse room with a lamp, so that no path escapes.
#include <array>
#include <utility>

#include "host/generate/databases.h"
#include "host/generate/value_noise.h"

namespace candela::generate {
namespace {

constexpr glm::dvec3 kCentre{0, 0, 1.8};
constexpr double kLeastRadius = 1;
constexpr double kRelief = 0.6;
constexpr double kFrequency = 2;  ///< of the bumps, in wavelengths per radian
constexpr std::uint32_t kOctaves = 5;

/// The room, and the lamp in its ceiling.
constexpr glm::dvec3 kLow{-2.5, -5, 0};
constexpr glm::dvec3 kHigh{2.5, 2.5, 4.5};
constexpr glm::dvec3 kLampMiddle{0, -1, kHigh.z};
constexpr double kLampHalfWidth = 0.9;
constexpr double kRadiance = 10;

/// Of a cube's face: the axis that it is normal to, on which side, and the axes of its grid, such that the three are
/// right-handed on the positive side.
struct Face {
  int normal;
  double side;
  int u() const { return (normal + 1) % 3; }
  int v() const { return (normal + 2) % 3; }
};
constexpr std::array<Face, 6> kFaces{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}};

/// A point of a face's grid of size x size cells, moved on to the bumpy sphere. Faces that meet have the same bits at
/// their common edges.
glm::dvec3 vertexAt(const Face& face, std::uint32_t i, std::uint32_t j, std::uint32_t size) {
  glm::dvec3 onCube;
  onCube[face.normal] = face.side;
  onCube[face.u()] = -1 + 2.0 * i / size;
  onCube[face.v()] = -1 + 2.0 * j / size;
  const glm::dvec3 direction = glm::normalize(onCube);
  return kCentre + direction * (kLeastRadius + kRelief * fractalNoise(direction * kFrequency, kOctaves));
}

void writeFaces(NffWriter& out, std::uint32_t size) {
  const std::uint64_t row = size + 1;
  std::uint64_t first = 1;
  for (const Face& face : kFaces) {
    for (std::uint64_t j = 0; j < size; ++j) {
      for (std::uint64_t i = 0; i < size; ++i) {
        const std::uint64_t corner = first + j * row + i;
        // On the negative side u and v turn clockwise, seen from outside.
        const std::uint64_t next = face.side > 0 ? corner + 1 : corner + row;
        const std::uint64_t previous = face.side > 0 ? corner + row : corner + 1;
        out.meshFace(corner, next, corner + row + 1);
        out.meshFace(corner + row + 1, previous, corner);
      }
    }
    first += row * row;
  }
}

void writeBumpySphere(NffWriter& out, std::uint32_t size) {
  const std::uint64_t verticesOfFace = (std::uint64_t{size} + 1) * (size + 1);
  out.surface({{0.75, 0.7, 0.6}, 1, 0, 0, 0, 1});
  out.mesh(kFaces.size() * verticesOfFace, kFaces.size() * 2 * size * size);
  for (const Face& face : kFaces) {
    for (std::uint32_t j = 0; j <= size; ++j) {
      for (std::uint32_t i = 0; i <= size; ++i) out.meshVertex(vertexAt(face, i, j, size));
    }
  }
  writeFaces(out, size);
}

/// The four corners of the room on a face's side, counter-clockwise from inside.
std::array<glm::dvec3, 4> wall(const Face& face) {
  const glm::dvec3& origin = face.side > 0 ? kHigh : kLow;
  const glm::dvec3 extent = (kHigh - kLow) * -face.side;
  glm::dvec3 u(0);
  glm::dvec3 v(0);
  u[face.u()] = extent[face.u()];
  v[face.v()] = extent[face.v()];
  if (face.side > 0) std::swap(u, v);
  return {origin, origin + u, origin + u + v, origin + v};
}

/// A frame round the lamp, which closes it: no light gets behind.
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
  static constexpr std::array<Face, 5> kWallsAndFloor{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, -1}}};
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
  writeBumpySphere(out, size);
}

}  // namespace candela::generate
