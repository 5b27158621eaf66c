// Meshes in the place that a transform gives them.
#pragma once
#include <glm/glm.hpp>

#include "host/scene/mesh.h"

namespace candela::mitsuba {

/// Moves the vertices of a mesh, rounding each coordinate once. Fronts stay fronts where the map mirrors. Normals and
/// tangents get unit length; a normal without one becomes that of a triangle. Returns whether all coordinates are in
/// the range of single precision.
bool place(scene::Mesh& mesh, const glm::dmat4& map);

/// Exchanges fronts and backs.
void flip(scene::Mesh& mesh);

/// Returns whether every edge of a triangle is that of another one in the opposite direction, where equal positions are
/// one: then no back is visible from outside.
bool isClosed(const scene::Mesh& mesh);

/// Returns the triangles of a mesh without attributes, moved by `distance` towards their backs. They are larger by
/// eight times the distance on all sides, so that a mesh is hidden behind them except at angles above 82 degrees.
scene::Mesh backingOf(const scene::Mesh& mesh, double distance);

/// Returns the largest coordinate in magnitude.
double reachOf(const scene::Mesh& mesh);

}  // namespace candela::mitsuba
