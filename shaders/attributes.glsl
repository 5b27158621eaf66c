// Attributes of triangles, interpolated: texture coordinates, vertex colours and tangents. shared/scene_rows.h has their layout.
#ifndef CANDELA_ATTRIBUTES_GLSL
#define CANDELA_ATTRIBUTES_GLSL
#include "placements.glsl"
#include "scene_access.glsl"

// Returns the mean of the values at the three vertices.
vec3 interpolated(vec3 at0, vec3 at1, vec3 at2, vec2 weights) {
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

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

// Returns the mean of the vertex normals of a triangle of an instance, or of none, whose attributes begin at `row`.
vec3 normalAt(uint row, uint instance, vec2 weights) {
  vec3 n0 = sceneRowFloat(row).xyz;
  vec3 n1 = sceneRowFloat(row + 1u).xyz;
  vec3 n2 = sceneRowFloat(row + 2u).xyz;
  if (kHasInstances && instance != 0u) {
    n0 = placedNormal(instance, n0);
    n1 = placedNormal(instance, n1);
    n2 = placedNormal(instance, n2);
  }
  return interpolated(n0, n1, n2, weights);
}

// Returns the unit tangent at a point of such a triangle and its handedness, or 0 if the vertices' tangents cancel out.
vec4 tangentAt(uint row, uint kind, uint instance, vec2 weights) {
  uint tangentRow = colourRow(row, kind) + ((kind & kFlagColours) != 0u ? kColourRows : 0u);
  vec3 t0 = sceneRowFloat(tangentRow).xyz;
  vec3 t1 = sceneRowFloat(tangentRow + 1u).xyz;
  vec3 t2 = sceneRowFloat(tangentRow + 2u).xyz;
  if (kHasInstances && instance != 0u) {
    t0 = placedTangent(instance, t0);
    t1 = placedTangent(instance, t1);
    t2 = placedTangent(instance, t2);
  }
  vec3 mean = interpolated(t0, t1, t2, weights);
  float squared = dot(mean, mean);
  if (squared == 0.0) return vec4(0.0);
  return vec4(mean * (1.0 / sqrt(squared)), sceneRowFloat(tangentRow).w);
}

#endif
