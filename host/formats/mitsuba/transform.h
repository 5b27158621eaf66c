// Transforms: <transform> with its operations.
#pragma once
#include <glm/glm.hpp>

#include "host/formats/mitsuba/xml_tree.h"

namespace candela::mitsuba {

/// Returns the matrix of one operation: <translate>, <rotate> (degrees), <scale>, <lookat>, <matrix> (9 or 16 numbers,
/// row by row). The parameters of its attributes are replaced already. Throws PlacedError.
glm::dmat4 operationOf(const Element& element);

/// Returns a unit vector perpendicular to a unit vector, as Mitsuba chooses it.
glm::dvec3 perpendicularTo(const glm::dvec3& direction);

/// Returns whether a map preserves angles (up to 1e-3, relative to its scale).
bool isSimilarity(const glm::dmat4& map);

/// Returns the image of a point.
inline glm::dvec3 placed(const glm::dmat4& map, const glm::dvec3& point) { return {map * glm::dvec4(point, 1)}; }
/// Returns the image of a direction, with its length.
inline glm::dvec3 turned(const glm::dmat4& map, const glm::dvec3& direction) {
  return {map * glm::dvec4(direction, 0)};
}

}  // namespace candela::mitsuba
