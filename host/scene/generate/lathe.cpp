// Places vertices around the axis, one row for each end of a step of the profile where it has an edge.
#include "host/scene/generate/lathe.h"

#include <cmath>
#include <numbers>

namespace candela::generate {
namespace {

using glm::dvec2;

// A vertex row: a point of the profile with a normal in the plane of the profile.
struct ProfileRow {
  dvec2 point;
  dvec2 normal;
  double fraction;
};

dvec2 stepNormal(const std::vector<dvec2>& profile, std::size_t step) {
  const dvec2 along = normalize(profile[step + 1] - profile[step]);
  return {along.y, -along.x};
}

// Normal at an end of a step: the mean of both steps' normals, unless the profile has an edge there.
dvec2 normalAt(const std::vector<dvec2>& profile, std::size_t step, bool atEnd) {
  const dvec2 own = stepNormal(profile, step);
  const bool hasNeighbour = atEnd ? step + 2 < profile.size() : step > 0;
  if (!hasNeighbour) return profile[atEnd ? step + 1 : step].x == 0 ? dvec2(0, own.y < 0 ? -1 : 1) : own;
  const dvec2 other = stepNormal(profile, atEnd ? step + 1 : step - 1);
  const double kSmooth = std::cos(40 * std::numbers::pi / 180);
  return dot(own, other) < kSmooth ? own : normalize(own + other);
}

void appendRow(TriangleMesh& mesh, const ProfileRow& row, std::uint32_t segments) {
  for (std::uint32_t i = 0; i <= segments; ++i) {
    const double turn = static_cast<double>(i) / segments;
    const double c = std::cos(2 * std::numbers::pi * turn), s = std::sin(2 * std::numbers::pi * turn);
    mesh.positions.emplace_back(row.point.x * c, row.point.y, -row.point.x * s);
    mesh.normals.emplace_back(row.normal.x * c, row.normal.y, -row.normal.x * s);
    mesh.texCoords.emplace_back(turn, 1 - row.fraction);
  }
}

}  // namespace

TriangleMesh lathe(const std::vector<dvec2>& profile, std::uint32_t segments) {
  TriangleMesh mesh;
  const double steps = static_cast<double>(profile.size() - 1);
  for (std::size_t step = 0; step + 1 < profile.size(); ++step) {
    const auto lower = static_cast<std::uint32_t>(mesh.positions.size());
    const std::uint32_t upper = lower + segments + 1;
    const double at = static_cast<double>(step);
    appendRow(mesh, {profile[step], normalAt(profile, step, false), at / steps}, segments);
    appendRow(mesh, {profile[step + 1], normalAt(profile, step, true), (at + 1) / steps}, segments);
    for (std::uint32_t i = 0; i < segments; ++i) {
      if (profile[step].x > 0) mesh.indices.insert(mesh.indices.end(), {lower + i, lower + i + 1, upper + i + 1});
      if (profile[step + 1].x > 0) mesh.indices.insert(mesh.indices.end(), {lower + i, upper + i + 1, upper + i});
    }
  }
  return mesh;
}

std::uint64_t latheTriangles(const std::vector<dvec2>& profile, std::uint32_t segments) {
  std::uint64_t count = 0;
  for (std::size_t step = 0; step + 1 < profile.size(); ++step) {
    count += segments * (std::uint64_t{profile[step].x > 0} + std::uint64_t{profile[step + 1].x > 0});
  }
  return count;
}

std::vector<dvec2> sphereProfile(double radius, std::uint32_t rings) {
  std::vector<dvec2> profile;
  for (std::uint32_t i = 0; i <= rings; ++i) {
    const double angle = std::numbers::pi * i / rings;
    const bool isPole = i == 0 || i == rings;
    profile.emplace_back(isPole ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return profile;
}

TriangleMesh square(double halfWidth, double repeats) {
  const auto h = static_cast<float>(halfWidth);
  const auto r = static_cast<float>(repeats);
  return {{{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}},
          std::vector<glm::vec3>(4, glm::vec3(0, 1, 0)),
          {{0, r}, {r, r}, {r, 0}, {0, 0}},
          {0, 1, 2, 0, 2, 3}};
}

}  // namespace candela::generate
