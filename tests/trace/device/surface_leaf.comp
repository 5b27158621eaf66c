// The surface points of closest hits under test. Input, two rows: (origin, .) (direction, .). Output, two rows:
// (position, 1 of a hit or 0) (colour of the vertices, primitive index).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface_point.glsl"
#include "traversal.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Work work = Work(0u, 0u);
  Ray ray = makeRay(inputs[2u * i].xyz, inputs[2u * i + 1u].xyz, kNoSlot);
  Hit hit = traceClosest(ray, work);
  bool missed = hit.t >= kNoHit;
  outputs[2u * i] = vec4(0.0);
  if (missed) return;
  Surface surface = surfaceAt(ray, hit);
  outputs[2u * i] = vec4(surface.position, 1.0);
  outputs[2u * i + 1u] = vec4(surface.colour, float(surface.index));
}
