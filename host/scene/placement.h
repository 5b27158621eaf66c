// The place of a mesh that a scene stores once and shows several times: docs/light-transport.md section 4.1.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace candela::scene {

/// Three rows of a matrix. With the fourth component, an affine map: a row (a, b, c, d) gives ((a x + b y) + c z) + d.
using PlacementRows = std::array<glm::vec4, 3>;

/// An affine map from the space of a mesh to that of the scene, in single precision. Its parts are applied in a fixed
/// order of operations, each rounded to nearest, so that both tracers place a vertex at the same point to the last bit.
struct Placement {
  PlacementRows points;   ///< linear part and translation
  PlacementRows normals;  ///< the inverse of the linear part, transposed, times a positive number; the last column is 0

  bool operator==(const Placement&) const = default;
};

/// Largest condition number of the linear part, as bounded by 9 max |A_ij| max |(A^-1)_ij|.
inline constexpr double kMaxCondition = 4096;

/// Returns an affine map as a placement, each entry rounded once; nothing if its condition number is above
/// kMaxCondition, or if it is not finite.
std::optional<Placement> placementOf(const glm::dmat4& map);

/// Returns the linear part A of a placement's points, exactly.
glm::dmat3 linearPartOf(const Placement& placement);
/// Returns the translation b of a placement's points, exactly.
glm::dvec3 translationOf(const Placement& placement);
/// Returns the inverse of A, each entry computed in double precision and rounded once.
glm::mat3 inverseOf(const Placement& placement);
/// Returns a matrix with the magnitudes of the entries.
glm::dmat3 magnitudesOf(const glm::dmat3& m);
/// Returns det(M) times the inverse transposed, which exists for singular matrices too.
glm::dmat3 cofactorsOf(const glm::dmat3& m);

/// Returns whether a map mirrors: whether its determinant is negative.
inline bool mirrors(const glm::dmat4& map) { return glm::determinant(glm::dmat3(map)) < 0; }

namespace detail {

inline glm::vec3 applyLinear(const PlacementRows& rows, const glm::vec3& v) {
  const auto component = [&](const glm::vec4& row) { return (row.x * v.x + row.y * v.y) + row.z * v.z; };
  return {component(rows[0]), component(rows[1]), component(rows[2])};
}

}  // namespace detail

inline glm::vec3 placedPoint(const Placement& placement, const glm::vec3& point) {
  const glm::vec3 turned = detail::applyLinear(placement.points, point);
  return {turned.x + placement.points[0].w, turned.y + placement.points[1].w, turned.z + placement.points[2].w};
}

/// The result has any length: normals are interpolated before they are normalised.
inline glm::vec3 placedNormal(const Placement& placement, const glm::vec3& normal) {
  return detail::applyLinear(placement.normals, normal);
}

/// The result's direction has any length. Its handedness is that of the mesh, see Scene::placements.
inline glm::vec4 placedTangent(const Placement& placement, const glm::vec4& tangent) {
  return {detail::applyLinear(placement.points, glm::vec3(tangent)), tangent.w};
}

}  // namespace candela::scene
