// teapot: Newell's teapot, each of its patches divided into n x n pieces of two triangles, on a chequered board of n x
// n squares.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "host/scene/generate/databases.h"

namespace candela::generate {
namespace {

/// A bicubic Bezier patch with 16 control points.
using BezierPatch = std::array<std::array<glm::dvec3, 4>, 4>;

/// A control point of a profile: its distance from the axis, its height, and the distance of the inner control points
/// of a quarter circle along their tangent, as a fraction of the distance from the axis.
struct ProfilePoint {
  double radius;
  double height;
  double tangent = 0.56;
};
using Profile = std::array<ProfilePoint, 4>;

constexpr Profile kRim{{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}};
constexpr Profile kUpperBody{{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}};
constexpr Profile kLowerBody{{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}};
constexpr Profile kKnob{{{0, 3.15}, {0.8, 3.15, 0.5625}, {0, 2.85}, {0.2, 2.7}}};
constexpr Profile kLid{{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}};
constexpr Profile kBottom{{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}};

/// The half at y <= 0 of parts that are symmetric about y = 0.
constexpr BezierPatch kUpperHandle{{{{{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}}},
                                    {{{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}}},
                                    {{{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3, -0.3, 2.25}, {-3, 0, 2.25}}},
                                    {{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}}}};
constexpr BezierPatch kLowerHandle{
    {{{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3, -0.3, 1.8}, {-3, 0, 1.8}}},
     {{{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3, -0.3, 1.35}, {-3, 0, 1.35}}},
     {{{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}}},
     {{{-2, 0, 0.9}, {-2, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}}}};
constexpr BezierPatch kLowerSpout{{{{{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}}},
                                   {{{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}}},
                                   {{{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}}},
                                   {{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}}}};
constexpr BezierPatch kUpperSpout{
    {{{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}},
     {{{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}}},
     {{{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}}},
     {{{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}}}};

class Assembly {
 public:
  /// Appends four quarters of a surface of revolution. The first begins at +x; they follow clockwise (`sense` -1) or
  /// counter-clockwise (1), seen from above.
  void revolve(const Profile& profile, double sense) {
    BezierPatch quarter;
    for (std::size_t row = 0; row < 4; ++row) {
      const auto& [radius, height, tangent] = profile[row];
      const double inner = radius * tangent;
      quarter[row] = {{{radius, 0, height},
                       {radius, sense * inner, height},
                       {inner, sense * radius, height},
                       {0, sense * radius, height}}};
    }
    for (int i = 0; i < 4; ++i) {
      add(quarter);
      for (auto& row : quarter) {
        for (glm::dvec3& point : row) point = {-sense * point.y, sense * point.x, point.z};
      }
    }
  }

  void addWithMirrorImage(BezierPatch patch) {
    add(patch);
    for (auto& row : patch) {
      std::ranges::reverse(row);  // keeps the front of the patch outside
      for (glm::dvec3& point : row) point.y = -point.y;
    }
    add(patch);
  }

  const std::array<BezierPatch, 32>& patches() const { return patches_; }

 private:
  void add(const BezierPatch& patch) { patches_[count_++] = patch; }

  std::array<BezierPatch, 32> patches_{};
  std::size_t count_ = 0;
};

/// Returns M. Newell's data of 1975 as published with a bottom (F. Crow, IEEE CG&A 7(1), 1987), z up: rim, body,
/// handle, spout, lid, bottom.
std::array<BezierPatch, 32> teapotPatches() {
  Assembly teapot;
  for (const Profile& profile : {kRim, kUpperBody, kLowerBody}) teapot.revolve(profile, -1);
  for (const BezierPatch& patch : {kUpperHandle, kLowerHandle, kLowerSpout, kUpperSpout}) {
    teapot.addWithMirrorImage(patch);
  }
  for (const Profile& profile : {kKnob, kLid}) teapot.revolve(profile, -1);
  teapot.revolve(kBottom, 1);
  return teapot.patches();
}

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
