// The light tree under proof. Input, two rows: (position, 1 if the receiver transmits) (normal, sample index, or the entry
// of an emitter). Output: (entry, probability, truncated, 0).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lights.glsl"

const uint kChoose = 0u;

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint task; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

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
    outputs[i] = vec4(float(entry), light.probability, float(truncated), 0.0);
  } else {
    Surface emitter;
    emitter.light = uint(facing.w) + 1u;
    outputs[i] = vec4(facing.w, emitterFound(emitter, place.xyz, receiver, truncated).probability, float(truncated), 0.0);
  }
}
