// teapot: Newell's teapot, each of its patches divided into n x n pieces of two triangles, on a chequered board of n x
// n squares.
#include <array>
#include <cmath>

#include "host/scene/generate/databases.h"
#include "host/scene/generate/teapot_patches.h"

namespace candela::generate {
namespace {

struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;  ///< unit vector to the outside
};

using Weights = std::array<double, 4>;

/// Cubic Bernstein polynomials.
Weights bernstein(double t) {
  const double u = 1 - t;
  return {u * u * u, 3 * t * u * u, 3 * t * t * u, t * t * t};
}

Weights bernsteinDerivatives(double t) {
  const double u = 1 - t;
  return {-3 * u * u, 3 * u * u - 6 * t * u, 6 * t * u - 3 * t * t, 3 * t * t};
}

glm::dvec3 weightedSum(const BezierPatch& patch, const Weights& rows, const Weights& columns) {
  glm::dvec3 sum(0);
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) sum += rows[row] * columns[column] * patch[row][column];
  }
  return sum;
}

/// At the poles, where the lid and the bottom close on the axis, a row of control points is a single point.
bool isPole(const glm::dvec3& position) {
  constexpr double kNear = 1e-4;
  return std::abs(position.x) < kNear && std::abs(position.y) < kNear;
}

/// `s` is the parameter along the columns of control points, `t` that along the rows, both in [0, 1].
SurfacePoint pointAt(const BezierPatch& patch, double s, double t) {
  const glm::dvec3 position = weightedSum(patch, bernstein(s), bernstein(t));
  if (isPole(position)) return {position, {0, 0, position.z > 1.5 ? 1 : -1}};
  const glm::dvec3 alongS = weightedSum(patch, bernsteinDerivatives(s), bernstein(t));
  const glm::dvec3 alongT = weightedSum(patch, bernstein(s), bernsteinDerivatives(t));
  return {position, glm::normalize(glm::cross(alongT, alongS))};
}

/// Writes nothing for a triangle that degenerates to a line at a pole.
void writeTriangle(NffWriter& out, const std::array<SurfacePoint, 3>& corners) {
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec3, 3> normals;
  int poles = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    positions[i] = corners[i].position;
    normals[i] = corners[i].normal;
    poles += isPole(positions[i]) ? 1 : 0;
  }
  if (poles <= 1) out.patch(positions, normals);
}

void writePatch(NffWriter& out, const BezierPatch& patch, std::uint32_t size) {
  const auto parameter = [&](std::uint32_t step) { return static_cast<double>(step) / size; };
  for (std::uint32_t i = 0; i < size; ++i) {
    for (std::uint32_t j = 0; j < size; ++j) {
      const SurfacePoint a = pointAt(patch, parameter(i), parameter(j));
      const SurfacePoint b = pointAt(patch, parameter(i), parameter(j + 1));
      const SurfacePoint c = pointAt(patch, parameter(i + 1), parameter(j + 1));
      const SurfacePoint d = pointAt(patch, parameter(i + 1), parameter(j));
      writeTriangle(out, {a, b, c});
      writeTriangle(out, {c, d, a});
    }
  }
}

/// Writes the squares (i, j) with (i + j) mod 2 = `parity`.
void writeSquares(NffWriter& out, std::uint32_t size, std::uint32_t parity) {
  const auto place = [&](std::uint32_t step) { return 4 * (2 * static_cast<double>(step) / size - 1); };
  for (std::uint32_t i = 0; i < size; ++i) {
    for (std::uint32_t j = 0; j < size; ++j) {
      if ((i + j) % 2 != parity) continue;
      const double x[] = {place(i), place(i + 1)};
      const double y[] = {place(j), place(j + 1)};
      out.polygon(std::array<glm::dvec3, 4>{{{x[0], y[0], 0}, {x[1], y[0], 0}, {x[1], y[1], 0}, {x[0], y[1], 0}}});
    }
  }
}

}  // namespace

std::uint64_t teapotPrimitives(std::uint32_t size) {
  const std::uint64_t n = size;
  const std::uint64_t board = 2 * n * n;
  return 32 * 2 * n * n - 8 * n + board;
}

void writeTeapot(NffWriter& out, std::uint32_t size) {
  out.background(kSkyBlue);
  out.view({{4.86, 7.2, 5.4}, {0, 0, 0}, {0, 0, 1}, 45, 1});
  out.light({-3.1, 9.8, 12.1});
  out.light({11.3, 5.1, 8.8});
  out.surface({{1, 1, 1}, 0.5, 0.5, 30, 0, 0});
  writeSquares(out, size, 1);
  out.surface({{0.5, 0.5, 0.5}, 0.5, 0.5, 30, 0, 0});
  writeSquares(out, size, 0);
  out.surface({{1, 0.5, 0.1}, 0.75, 0.25, 37, 0, 0});
  for (const BezierPatch& patch : teapotPatches()) writePatch(out, patch, size);
}

}  // namespace candela::generate
