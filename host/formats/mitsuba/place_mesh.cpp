// Transforms meshes, and searches their edges.
#include "host/formats/mitsuba/place_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "host/formats/loading/vertex_normals.h"
#include "host/formats/mitsuba/transform.h"
#include "host/scene/placement.h"

namespace candela::mitsuba {
namespace {

/// Returns for each vertex the number of its position; equal ones have equal numbers.
std::vector<std::uint32_t> positionNumbers(const scene::Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const glm::vec3& p = mesh.positions[i];
    return std::array<float, 3>{p.x, p.y, p.z};
  };
  std::ranges::sort(order, {}, key);
  std::vector<std::uint32_t> numbers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isKnown = i > 0 && key(order[i]) == key(order[i - 1]);
    numbers[order[i]] = isKnown ? numbers[order[i - 1]] : static_cast<std::uint32_t>(i);
  }
  return numbers;
}

glm::dvec3 normalOf(const scene::Mesh& mesh, std::uint32_t triangle) {
  const auto [a, b, c] = attributeOf(mesh, mesh.positions, triangle);
  return glm::dvec3(scene::unitNormalOrZero(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a))));
}

/// Moves the corners of a triangle outwards in its plane, so that its sides move by `margin`; corners move by at most
/// twice the margin.
std::array<glm::dvec3, 3> enlarged(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal, double margin) {
  std::array<glm::dvec3, 3> outward;  // from the side after each corner
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 side = corners[(i + 1) % 3] - corners[i];
    outward[i] = glm::length(side) > 0 ? glm::normalize(glm::cross(side, normal)) : glm::dvec3(0);
  }
  std::array<glm::dvec3, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& before = outward[(i + 2) % 3];
    const double scale = std::min(1 / std::max(1 + glm::dot(before, outward[i]), 1e-9), 2.0);
    result[i] = corners[i] + margin * scale * (before + outward[i]);
  }
  return result;
}

}  // namespace

bool place(scene::Mesh& mesh, const glm::dmat4& map) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  bool isInRange = true;
  for (glm::vec3& position : mesh.positions) {
    const glm::dvec3 p = placed(map, glm::dvec3(position));
    isInRange = isInRange && glm::all(glm::lessThan(glm::abs(p), glm::dvec3(kLargest)));
    position = isInRange ? glm::vec3(p) : glm::vec3(0);
  }
  const bool isMirrored = scene::mirrors(map);
  const glm::dmat3 cofactors = scene::cofactorsOf(glm::dmat3(map)) * (isMirrored ? -1.0 : 1.0);
  for (glm::vec3& normal : mesh.normals) normal = scene::unitNormalOrZero(cofactors * glm::dvec3(normal));
  for (glm::vec4& tangent : mesh.tangents) {
    const glm::vec3 direction = scene::unitNormalOrZero(turned(map, glm::dvec3(tangent)));
    tangent = glm::vec4(direction, isMirrored ? -tangent.w : tangent.w);
  }
  if (isMirrored) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
  if (!mesh.normals.empty()) scene::replaceZeroNormals(mesh);
  return isInRange;
}

void flip(scene::Mesh& mesh) {
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  for (glm::vec3& normal : mesh.normals) normal = -normal;
  for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
}

bool isClosed(const scene::Mesh& mesh) {
  const std::vector<std::uint32_t> numbers = positionNumbers(mesh);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, opposite;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = numbers[mesh.indices[i + c]], b = numbers[mesh.indices[i + (c + 1) % 3]];
      if (a == b) continue;
      edges.emplace_back(a, b);
      opposite.emplace_back(b, a);
    }
  }
  std::ranges::sort(edges);
  std::ranges::sort(opposite);
  return edges == opposite;
}

scene::Mesh backingOf(const scene::Mesh& mesh, double distance) {
  constexpr double kMargin = 8;
  scene::Mesh backing;
  for (std::uint32_t triangle = 0; triangle < scene::triangleCount(mesh); ++triangle) {
    const glm::dvec3 normal = normalOf(mesh, triangle);
    if (normal == glm::dvec3(0)) continue;
    const auto [a, b, c] = attributeOf(mesh, mesh.positions, triangle);
    for (const glm::dvec3& corner :
         enlarged({glm::dvec3(a), glm::dvec3(b), glm::dvec3(c)}, normal, kMargin * distance)) {
      backing.indices.push_back(static_cast<std::uint32_t>(backing.positions.size()));
      backing.positions.emplace_back(corner - distance * normal);
    }
  }
  return backing;
}

double reachOf(const scene::Mesh& mesh) {
  double reach = 0;
  for (const glm::vec3& p : mesh.positions) {
    reach = std::max({reach, std::abs(double{p.x}), std::abs(double{p.y}), std::abs(double{p.z})});
  }
  return reach;
}

}  // namespace candela::mitsuba
