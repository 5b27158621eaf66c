// Placements of instances: docs/light-transport.md section 4.1. shared/scene_rows.h has the layout of their records. An
// instance is given by its number, which is 0 for primitives that belong to none.
#ifndef CANDELA_PLACEMENTS_GLSL
#define CANDELA_PLACEMENTS_GLSL
#include "scene_access.glsl"

// The columns of A and b.
struct Placement {
  vec3 columns[4];
  uint firstPrimitive;  // index of the instance's first primitive
};

uint instanceRow(uint instance) { return constants.firstInstanceRow + (instance - 1u) * kInstanceRows; }

Placement loadPlacement(uint instance) {
  uint row = instanceRow(instance);
  uvec4 first = sceneRow(row);
  return Placement(vec3[4](uintBitsToFloat(first.xyz), sceneRowFloat(row + 1u).xyz, sceneRowFloat(row + 2u).xyz,
                           sceneRowFloat(row + 3u).xyz), first.w);
}

// The order of operations is that of scene::placedPoint() on the host.
vec3 placedVector(vec3 x, vec3 y, vec3 z, vec3 v) {
  precise vec3 result = (x * v.x + y * v.y) + z * v.z;
  return result;
}

vec3 placedPoint(Placement placement, vec3 point) {
  precise vec3 result = placedVector(placement.columns[0], placement.columns[1], placement.columns[2], point) +
                        placement.columns[3];
  return result;
}

// The matrices that place directions, by their first records of an instance's.
const uint kNormalMatrix = 4u;
const uint kTangentMatrix = 0u;

vec3 placedDirection(uint instance, uint matrix, vec3 direction) {
  uint row = instanceRow(instance) + matrix;
  return placedVector(sceneRowFloat(row).xyz, sceneRowFloat(row + 1u).xyz, sceneRowFloat(row + 2u).xyz, direction);
}

// Returns the records of a triangle of an instance as those of other triangles are: with the vertices in the scene, and with
// the primitive index in it.
uvec4[3] placedRows(Placement placement, uvec4 rows[3]) {
  rows[0].xyz = floatBitsToUint(placedPoint(placement, uintBitsToFloat(rows[0].xyz)));
  rows[1].xyz = floatBitsToUint(placedPoint(placement, uintBitsToFloat(rows[1].xyz)));
  rows[2].xyz = floatBitsToUint(placedPoint(placement, uintBitsToFloat(rows[2].xyz)));
  rows[1].w += placement.firstPrimitive;
  return rows;
}

// Returns the records of any primitive.
uvec4[3] placedRowsOf(uint slot, uint instance) {
  if (!kHasInstances || instance == 0u) return rowsOfSlot(slot);
  return placedRows(loadPlacement(instance), rowsOfSlot(slot));
}

#endif
