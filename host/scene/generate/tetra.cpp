// tetra: Sierpinski's tetrahedron, which consists of four of half its size at its corners.
#include <array>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

/// The corners of a cube of half width 1 that span a tetrahedron: those whose coordinates have the product 1.
constexpr std::array<glm::dvec3, 4> kCorners{{{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 4> kTetrahedronFaces{{{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}}};

/// Writes the tetrahedron in the cube of `halfWidth` around `centre`.
void writeTetrahedron(NffWriter& out, const glm::dvec3& centre, double halfWidth) {
  for (const auto& face : kTetrahedronFaces) {
    std::array<glm::dvec3, 3> vertices;
    for (std::size_t i = 0; i < 3; ++i) vertices[i] = centre + halfWidth * kCorners[face[i]];
    out.polygon(vertices);
  }
}

void writePyramid(NffWriter& out, const glm::dvec3& centre, double halfWidth, std::uint32_t levels) {
  if (levels == 1) return writeTetrahedron(out, centre, halfWidth);
  for (const glm::dvec3& corner : kCorners)
    writePyramid(out, centre + halfWidth / 2 * corner, halfWidth / 2, levels - 1);
}

}  // namespace

std::uint64_t tetraPrimitives(std::uint32_t size) { return std::uint64_t{1} << (2 * size); }

void writeTetra(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view(
      {{1.022846, -3.177154, -2.174512}, {-0.004103, -0.004103, 0.216539}, {-0.816497, -0.816497, 0.816497}, 45, 1});
  out.light({2, -18, -5});
  out.surface({{1, 0.2, 0.2}, 1, 0, 0, 0, 0});
  writePyramid(out, {0, 0, 0}, 1, size);
}

}  // namespace candela::generate
