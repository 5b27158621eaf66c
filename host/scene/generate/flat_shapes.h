// Shapes with flat faces, of which models are built.
#pragma once
#include "host/scene/generate/gltf_document.h"

namespace candela::generate {

/// Appends a flat quad whose corners are counter-clockwise, seen from its front.
void appendQuad(TriangleMesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// Appends a triangle whose corners are counter-clockwise, seen from its front.
void appendTriangle(TriangleMesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Appends a box with edges along the axes.
void appendBox(TriangleMesh& mesh, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace candela::generate
