// Meshes of the shapes that Mitsuba has built in, with texture coordinates; those that are curved have normals.
#pragma once
#include "host/scene/mesh.h"

namespace candela::mitsuba {

/// The square from (-1, -1, 0) to (1, 1, 0), with its front at +z.
scene::Mesh rectangleMesh();
/// The cube from (-1, -1, -1) to (1, 1, 1).
scene::Mesh cubeMesh();
/// The unit disk around the z axis, with its front at +z: a regular polygon of 256 sides with the area of the disk.
/// Texture coordinates: the distance from the centre, and the angle from the x axis as a fraction of a turn.
scene::Mesh diskMesh();
/// The lateral surface of the cylinder of radius 1 around the z axis from 0 to 1: 256 strips, whose vertices are on it.
scene::Mesh cylinderMesh();
/// The unit sphere: 256 by 128 patches, whose vertices are on it.
scene::Mesh sphereMesh();

}  // namespace candela::mitsuba
