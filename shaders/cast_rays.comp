// Entry point of the kernel that only traces given rays, one per invocation.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/cast_ray.h"
#include "traversal.glsl"

layout(local_size_x_id = kSpecWorkgroupX, local_size_y_id = kSpecWorkgroupY, local_size_z = 1) in;
layout(constant_id = kSpecOcclusion) const bool kOcclusion = false;
layout(push_constant) uniform Dispatch { CastConstants range; };
layout(set = 0, binding = kBindingPathStates, std430) readonly buffer Rays { CastRay rays[]; };
layout(set = 0, binding = kBindingFilm, std430) writeonly buffer Hits { CastHit hits[]; };

// Returns the index of this workgroup's work. Units of workgroups are processed in the order of a stride that is
// coprime to their number: docs/driver-workarounds.md section 11.
uint placeOfWorkgroup() {
  uint units = gl_NumWorkGroups.x / kCastUnit;
  uint unit = (gl_WorkGroupID.x / kCastUnit) * range.unitStride % units;
  return unit * kCastUnit + gl_WorkGroupID.x % kCastUnit;
}

void main() {
  uint i = range.first + placeOfWorkgroup() * range.invocations + gl_LocalInvocationIndex;
  if (i >= range.end) return;
  vec4 start = rays[i].originLimit;
  Ray ray = makeRay(start.xyz, rays[i].direction.xyz, kNoSlot);
  Work work = Work(0u, 0u);
  uvec2 found;
  if (kOcclusion) {
    found = uvec2(0u, traceAny(ray, RayEnd(start.w, kNoSlot, kNoPoint), work) ? 1u : 0u);
  } else {
    Hit hit = traceClosest(ray, work);
    found = uvec2(floatBitsToUint(hit.t), hit.t < kNoHit ? hit.index : kNoPrimitive);
  }
  hits[i].found = uvec4(found, work.steps, kLimitsLoops ? work.truncated : 0u);
}
