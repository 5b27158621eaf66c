// Polygons of files: their limit, and warnings about their shape.
#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/triangulate.h"

namespace candela::scene {

inline constexpr std::size_t kMaxPolygonVertices = 16384;  ///< triangulation takes quadratic time

/// Returns triangulate(polygon), and warns of a polygon that is not flat or that crosses itself.
Triangulation triangulateWithWarnings(std::span<const glm::vec3> polygon, Position position, DiagnosticLog& log);

}  // namespace candela::scene
