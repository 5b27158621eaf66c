// Computes the box around a scene.
#include "host/scene/bounds.h"

#include <cmath>
#include <limits>

#include "host/scene/placed_bounds.h"
#include "host/scene/shape.h"

namespace candela::scene {
namespace {

/// A growing box. It is computed in double precision and rounded to nearest at the end.
class Extent3 {
 public:
  void add(const glm::dvec3& centre, const glm::dvec3& halfSize = glm::dvec3(0)) {
    min_ = glm::min(min_, centre - halfSize);
    max_ = glm::max(max_, centre + halfSize);
  }
  std::optional<Bounds> bounds() const {
    if (min_.x > max_.x) return std::nullopt;
    return Bounds{glm::vec3(min_), glm::vec3(max_)};
  }

 private:
  glm::dvec3 min_{std::numeric_limits<double>::infinity()};
  glm::dvec3 max_{-std::numeric_limits<double>::infinity()};
};

void add(Extent3& extent, const Sphere& sphere) {
  extent.add(sphere.centre, glm::dvec3(std::abs(static_cast<double>(sphere.radius))));
}

void add(Extent3& extent, const Triangle& triangle) {
  for (const glm::vec3& vertex : triangle.p) extent.add(vertex);
}

void add(Extent3& extent, const Box& box) {
  extent.add(box.min);
  extent.add(box.max);
}

/// Adds consecutive triangles of a mesh. Single precision suffices: every bound is a coordinate of a vertex.
void add(Extent3& extent, const Mesh& mesh, std::size_t first, std::size_t count) {
  if (count == 0) return;
  glm::vec3 min(std::numeric_limits<float>::infinity()), max(-std::numeric_limits<float>::infinity());
  for (std::size_t corner = 3 * first; corner < 3 * (first + count); ++corner) {
    const glm::vec3& vertex = mesh.positions[mesh.indices.empty() ? corner : mesh.indices[corner]];
    min = glm::min(min, vertex);
    max = glm::max(max, vertex);
  }
  extent.add(min), extent.add(max);
}

/// A circle around a unit axis reaches r sqrt(1 - axis^2) along each coordinate.
void add(Extent3& extent, const Cone& cone) {
  const glm::dvec3 base = cone.base;
  const glm::dvec3 apex = cone.apex;
  const glm::dvec3 axis = glm::normalize(apex - base);
  const glm::dvec3 reach = glm::sqrt(glm::max(1.0 - axis * axis, 0.0));
  extent.add(base, static_cast<double>(cone.baseRadius) * reach);
  extent.add(apex, static_cast<double>(cone.apexRadius) * reach);
}

/// Planes are infinite.
void add(Extent3&, const Plane&) {}

}  // namespace

std::optional<Bounds> boundsOf(const Scene& scene, const std::function<bool(const PrimitiveRun&)>& includes) {
  Extent3 extent;
  PlacedBounds placed(scene);
  for (const PrimitiveRun& run : scene.primitives.runs()) {
    if (includes && !includes(run)) continue;
    if (run.start.isPlaced()) {
      const auto [min, max] = placed.of(run);
      extent.add(min), extent.add(max);
      continue;
    }
    if (run.start.kind == PrimitiveKind::triangle) {
      add(extent, meshOf(scene, run.start), run.start.index, scene.primitives.countOf(run));
      continue;
    }
    const std::uint32_t end = run.first + scene.primitives.countOf(run);
    for (std::uint32_t i = run.first; i < end; ++i) {
      std::visit([&](const auto& shape) { add(extent, shape); }, shapeOf(scene, run.at(i)));
    }
  }
  return extent.bounds();
}

}  // namespace candela::scene
