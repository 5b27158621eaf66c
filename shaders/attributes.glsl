// Attributes of triangles, interpolated: texture coordinates, vertex colours and tangents. shared/scene_rows.h has their layout.
#ifndef CANDELA_ATTRIBUTES_GLSL
#define CANDELA_ATTRIBUTES_GLSL
#include "placements.glsl"
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

uint colourRow(uint row, uint kind) {
  return texCoordRow(row, kind) + ((kind & kFlagTexCoords) != 0u ? kTexCoordRows : 0u);
}

// Returns the vertex colour at a point of a triangle whose attributes begin at `row`.
vec4 colourAt(uint row, uint kind, vec2 weights) { return interpolatedRows(colourRow(row, kind), weights); }

// Returns the mean of the directions at the vertices, whose records begin at `row`. Those of an instance are placed by a
// matrix: kNormalMatrix or kTangentMatrix.
vec3 directionAt(uint row, uint instance, uint matrix, vec2 weights) {
  vec3 at0 = sceneRowFloat(row).xyz;
  vec3 at1 = sceneRowFloat(row + 1u).xyz;
  vec3 at2 = sceneRowFloat(row + 2u).xyz;
  if (kHasInstances && instance != 0u) {
    at0 = placedDirection(instance, matrix, at0);
    at1 = placedDirection(instance, matrix, at1);
    at2 = placedDirection(instance, matrix, at2);
  }
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

// Returns the unit tangent at a point of such a triangle and its handedness, or 0 if the vertices' tangents cancel out.
vec4 tangentAt(uint row, uint kind, uint instance, vec2 weights) {
  uint tangentRow = colourRow(row, kind) + ((kind & kFlagColours) != 0u ? kColourRows : 0u);
  vec3 mean = directionAt(tangentRow, instance, kTangentMatrix, weights);
  float squared = dot(mean, mean);
  if (squared == 0.0) return vec4(0.0);
  return vec4(mean * (1.0 / sqrt(squared)), sceneRowFloat(tangentRow).w);
}

#endif
