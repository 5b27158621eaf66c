// Attributes of triangles, interpolated: texture coordinates and vertex colours. shared/scene_rows.h has their layout.
#ifndef CANDELA_ATTRIBUTES_GLSL
#define CANDELA_ATTRIBUTES_GLSL
#include "scene_access.glsl"

vec4 interpolatedRows(uint row, vec2 weights) {
  vec4 at0 = sceneRowFloat(row);
  vec4 at1 = sceneRowFloat(row + 1u);
  vec4 at2 = sceneRowFloat(row + 2u);
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

uint texCoordRow(uint row, uint kind) { return row + ((kind & kFlagSmooth) != 0u ? kNormalRows : 1u); }

// Returns both sets of texture coordinates at a point of a triangle whose attributes begin at `row`.
vec4 texCoordsAt(uint row, uint kind, vec2 weights) { return interpolatedRows(texCoordRow(row, kind), weights); }

// Returns the vertex colour at such a point.
vec4 colourAt(uint row, uint kind, vec2 weights) {
  uint skipped = (kind & kFlagTexCoords) != 0u ? kTexCoordRows : 0u;
  return interpolatedRows(texCoordRow(row, kind) + skipped, weights);
}

#endif
