// The light tree under proof. Input, two rows: (position, 1 if the receiver transmits) (normal, sample index, or the index of
// a primitive that emits). Output: (entry, probability, truncated, index of the primitive).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lights.glsl"

const uint kChoose = 0u;

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint task; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

uint slotOfPrimitive(uint primitive) {
  uint slot = 0u;
  while (slot < constants.slotCount && indexOf(rowsOfSlot(slot)) != primitive) ++slot;
  return slot;
}

// Returns what surfaceAt() sets of an emitter.
Surface emitterAt(uint slot) {
  uvec4 rows[3] = rowsOfSlot(slot);
  Surface emitter;
  emitter.slot = slot;
  emitter.light = isKind(rows[2].w, kKindSphere) ? rows[2].x : lightOf(rows[0].w, indexOf(rows));
  return emitter;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 place = inputs[2u * i];
  vec4 facing = inputs[2u * i + 1u];
  uint receiver = packDirection(facing.xyz) | (place.w != 0.0 ? kReceiverTransmits : 0u);
  uint truncated = 0u;
  if (task == kChoose) {
    SampleKey key = SampleKey(0u, uint(facing.w), 0u, 0u);
    uint k = sampleGroup(key, vertexGroup(1u, kDimensionLightChoice)).x >> 8;
    uint entry;
    Light light = chooseLight(place.xyz, receiver, k, key, 1u, entry, truncated);
    uint primitive = light.slot == kNoSlot ? 0u : indexOf(rowsOfSlot(light.slot));
    outputs[i] = vec4(float(entry), light.probability, float(truncated), float(primitive));
  } else {
    Surface emitter = emitterAt(slotOfPrimitive(uint(facing.w)));
    float probability = emitterFound(emitter, place.xyz, receiver, truncated).probability;
    outputs[i] = vec4(0.0, emitter.light != 0u ? probability : 0.0, float(truncated), facing.w);
  }
}
