// The only file that declares the scene's buffers. Functions take indices and return values. A 16-byte record is called
// a row in names: see shared/scene_rows.h.
#ifndef CANDELA_SCENE_ACCESS_GLSL
#define CANDELA_SCENE_ACCESS_GLSL
#extension GL_EXT_control_flow_attributes : require
#include "options.glsl"
#include "shared/bindings.h"
#include "shared/render_data.h"
#include "shared/scene_rows.h"

layout(set = 0, binding = kBindingSceneRows, std430) readonly buffer SceneRows { uvec4 sceneRows[]; };
layout(set = 0, binding = kBindingSceneTexels) uniform usamplerBuffer sceneTexels;
layout(set = 0, binding = kBindingUniforms, std140) uniform Uniforms { RenderUniforms uniforms; };

// The constants are read before any branch or loop: docs/driver-workarounds.md section 1.
RenderConstants constants = uniforms.constants;

// With kRowsAhead, the records of slots are read ahead as well; otherwise this is one record that is never used:
// docs/driver-workarounds.md section 2.
const uint kRowsReadAhead = kRowsAhead && kUniformSlots > 0u ? kUniformSlots * kPrimitiveRows : 1u;
uvec4 slotRowsAhead[kRowsReadAhead];

bool readAhead() {
  [[unroll]] for (uint row = 0u; row < kRowsReadAhead; ++row) slotRowsAhead[row] = uniforms.slotRows[row];
  return true;
}

bool rowsWereReadAhead = readAhead();  // an initialiser, which every kernel executes first

uvec4 slotRow(uint row) {
  if (kRowsAhead) return slotRowsAhead[row];
  return uniforms.slotRows[row];
}

// Reads a record of the scene. Both buffer types give the same bits: docs/driver-workarounds.md section 9.
uvec4 sceneRow(uint row) {
  if (kTexelLoads) return texelFetch(sceneTexels, int(row));
  return sceneRows[row];
}

vec4 sceneRowFloat(uint row) { return uintBitsToFloat(sceneRow(row)); }

uint primitiveRow(uint slot) { return constants.firstPrimitiveRow + slot * kPrimitiveRows; }

uvec4[3] rowsOfSlot(uint slot) {
  uint row = primitiveRow(slot);
  return uvec4[3](sceneRow(row), sceneRow(row + 1u), sceneRow(row + 2u));
}

// Returns the primitive index of the primitive with these records.
uint indexOf(uvec4 rows[3]) { return rows[1].w; }

bool isKind(uint kind, uint wanted) { return kOnlyKind == wanted || (kind & kKindMask) == wanted; }

struct Light {
  float probability;  // in a scene with a light tree, the trail of a light of the tree
  uint kind;
  uint slot;
  vec3 emission;  // radiance; of a point light: its colour; of a punctual light: its intensity
  float area;     // of a triangle; of a spot light: records from the first light to that of its cone
  vec3 position;  // centre of a sphere, position of a light, or direction towards a directional light
  float radius;   // of a sphere; of a spot light: 1 / (difference of the cosines)
};

uint lightRow(uint light) { return constants.firstLightRow + light * kLightRows; }

Light loadLight(uint light) {
  uint row = lightRow(light);
  uvec4 head = sceneRow(row);
  uvec4 emission = sceneRow(row + 1u);
  vec4 position = sceneRowFloat(row + 2u);
  return Light(uintBitsToFloat(head.y), emission.w, head.w, uintBitsToFloat(emission.xyz), uintBitsToFloat(head.z),
               position.xyz, position.w);
}

struct PointLight {
  vec3 colour;
  vec3 position;  // centre of the square that the light fills
  vec3 edgeU;
  vec3 edgeV;
};

// Loads a point light from the records of the Whitted tracer.
PointLight loadPointLight(uint light) {
  uint row = constants.firstLightRow + light * kPointLightRows;
  PointLight result = PointLight(sceneRowFloat(row).xyz, sceneRowFloat(row + 1u).xyz, vec3(0.0), vec3(0.0));
  if (kHasAreaLights) {
    result.edgeU = sceneRowFloat(row + 2u).xyz;
    result.edgeV = sceneRowFloat(row + 3u).xyz;
  }
  return result;
}

// Returns the first of the thresholds low to high that exceeds a number, or `high`: the choice by a cumulative
// distribution. Threshold i is word `component` of the record first + stride i. The binary search takes at most 32
// iterations.
uint firstThresholdAbove(uint number, uint first, uint stride, uint component, uint low, uint high,
                         inout uint truncated) {
  uint cutShort = low < high ? 1u : 0u;  // docs/driver-workarounds.md section 4
  while (low < high) {
    uint middle = (low + high) / 2u;
    bool right = number >= sceneRow(first + stride * middle)[component];
    low = right ? middle + 1u : low;
    high = right ? high : middle;
    cutShort = low < high ? 1u : 0u;
    if (kMasksLanes && low >= high) break;
  }
  truncated += cutShort;
  return low;
}

// Returns the entry of the light table that a 24-bit number chooses.
uint entryChosenBy(uint k, inout uint truncated) {
  return firstThresholdAbove(k, constants.firstLightRow, kLightRows, 0u, 0u, constants.lightCount - 1u, truncated);
}

#endif
