// The light table under proof. Input, two rows: (position, 1 on the light itself) and, to choose, (upper 24 bits of the
// random word, ...), to sample, (u, v, ., entry), to find, (direction, entry). Output, two rows: (entry, probability,
// truncated, .), or (wi, pdf) (emission, distance), or (distance, pdf, ...).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lights.glsl"

const uint kChoose = 0u;
const uint kSample = 1u;

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint task; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

vec4 choice(uint number) {
  uint truncated = 0u;
  uint entry = entryChosenBy(number, truncated);
  return vec4(float(entry), loadLight(entry).probability, float(truncated), 0.0);
}

// Only its position and its slot matter: lights are sampled without regard to the surface's normal.
Surface surfaceOf(vec4 place, uint slot) {
  Surface surface;
  surface.position = place.xyz;
  surface.outward = vec3(0.0, 0.0, 1.0);
  surface.kind = 0u;
  surface.contact = 0u;
  surface.slot = place.w != 0.0 ? slot : kNoSlot;
  surface.flatSurface = false;
  surface.jitter = vec4(0.0);
  return surface;
}

vec4 found(Surface from, uint entry, uint slot, vec3 direction) {
  Ray ray = rayFrom(from, direction, false);
  float t = hitPrimitive(ray, slot, kAnyPrimitive).t;
  if (t >= kNoHit) return vec4(0.0);
  return vec4(t, lightPdf(loadLight(entry), ray, surfaceAt(ray, Hit(t, slot, 0u, 0u, false, t)), t), 0.0, 0.0);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 place = inputs[2u * i];
  vec4 query = inputs[2u * i + 1u];
  if (task == kChoose) {
    outputs[2u * i] = choice(uint(query.x));
    return;
  }
  Light light = loadLight(uint(query.w));
  Surface from = surfaceOf(place, light.slot);
  if (task == kSample) {
    LightSample lit = sampleLight(light, from, query.xy);
    outputs[2u * i] = vec4(lit.wi, lit.pdf);
    outputs[2u * i + 1u] = vec4(lit.emission, lit.distance);
  } else {
    outputs[2u * i] = found(from, uint(query.w), light.slot, query.xyz);
  }
}
