// Entry point of the views. They have a separate kernel: docs/driver-workarounds.md section 10.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "lanes.glsl"
#include "views.glsl"

// One segment is a whole sample.
bool extendSample(inout Path path, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions) {
  path.radiance = viewSample(path.ray, key, work, counts, decisions);
  return false;
}

void main() { advancePixel(gl_GlobalInvocationID.xy); }
