// Entry point of the path tracer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lanes.glsl"

bool extendSample(inout Path path, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions) {
  return extendPath(path, key, work, counts, decisions);
}

void main() { advancePixel(gl_GlobalInvocationID.xy); }
