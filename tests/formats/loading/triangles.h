// The triangles of a scene, for tests that examine all of them.
#pragma once
#include <vector>

#include "host/scene/scene.h"

namespace candela::scene {

/// In the order of the primitives.
inline std::vector<Triangle> trianglesOf(const Scene& scene) {
  std::vector<Triangle> triangles;
  for (const Primitive& primitive : scene.primitives) {
    if (primitive.kind == PrimitiveKind::triangle) triangles.push_back(triangleOf(scene, primitive));
  }
  return triangles;
}

/// Vertex normals of the smooth triangles, in the order of the primitives.
inline std::vector<VertexNormals> vertexNormalsOf(const Scene& scene) {
  std::vector<VertexNormals> normals;
  for (const Primitive& primitive : scene.primitives) {
    if (isSmooth(scene, primitive)) normals.push_back(vertexNormalsOf(scene, primitive));
  }
  return normals;
}

}  // namespace candela::scene
