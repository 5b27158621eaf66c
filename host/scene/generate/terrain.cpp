// terrain: hills as a height field in one mesh, lit by sun and sky, with a large number of triangles.
#include "host/scene/generate/databases.h"
#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

constexpr double kSide = 100;
constexpr double kHeight = 35;  ///< z lies in [0, kHeight)
constexpr std::uint32_t kHeightOctaves = 8;
constexpr double kWavelength = 25;  ///< wavelength of the first octave

glm::dvec3 vertexAt(std::uint32_t column, std::uint32_t row, std::uint32_t size) {
  const auto place = [&](std::uint32_t step) { return kSide * step / (size - 1); };
  const glm::dvec2 corner(place(column), place(row));
  const double height = kHeight * fractalNoise({corner / kWavelength, 0}, kHeightOctaves);
  return {corner - kSide / 2, height};
}

}  // namespace

std::uint64_t terrainPrimitives(std::uint32_t size) {
  const std::uint64_t cells = size - 1;
  return 2 * cells * cells;
}

void writeTerrain(NffWriter& out, std::uint32_t size) {
  out.background({0.4, 0.55, 0.8});
  out.view({{-85, -105, 85}, {0, 0, 6}, {0, 0, 1}, 45, 0});
  out.light({-3000, 1000, 2000});
  out.surface({{0.4, 0.35, 0.25}, 1, 0, 0, 0, 1});
  out.mesh(std::uint64_t{size} * size, terrainPrimitives(size));
  for (std::uint32_t row = 0; row < size; ++row) {
    for (std::uint32_t column = 0; column < size; ++column) out.meshVertex(vertexAt(column, row, size));
  }
  for (std::uint64_t row = 0; row + 1 < size; ++row) {
    for (std::uint64_t column = 0; column + 1 < size; ++column) {
      const std::uint64_t corner = row * size + column + 1;
      const std::uint64_t above = corner + size;
      out.meshFace(corner, corner + 1, above + 1);
      out.meshFace(above + 1, above, corner);
    }
  }
}

}  // namespace candela::generate
