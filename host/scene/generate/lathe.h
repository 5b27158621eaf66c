// Surfaces of revolution about the y axis, and flat squares, as triangle meshes.
#pragma once
#include <vector>

#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

/// Turns a profile of points (radius, height) about the y axis. The outside is to the right of the profile's direction,
/// so that a profile which rises beside the axis faces away from it. Normals are smooth; points where the profile turns
/// by more than 40 degrees become edges. `segments` >= 3 quads go around. Quads at the axis (radius 0) are triangles.
/// Texture coordinates are the fractions of the turn and of the profile's points.
TriangleMesh lathe(const std::vector<glm::dvec2>& profile, std::uint32_t segments);

/// Number of triangles of lathe().
std::uint64_t latheTriangles(const std::vector<glm::dvec2>& profile, std::uint32_t segments);

/// Profile of a sphere around the origin, from its lowest to its highest point, in `rings` steps.
std::vector<glm::dvec2> sphereProfile(double radius, std::uint32_t rings);

/// A square at height 0 with its front above; texture coordinates go from 0 to `repeats`.
TriangleMesh square(double halfWidth, double repeats);

}  // namespace candela::generate
