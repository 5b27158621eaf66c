// Volumes that surfaces bound, which absorb light: docs/light-transport.md section 5.6.
#ifndef CANDELA_VOLUMES_GLSL
#define CANDELA_VOLUMES_GLSL
#include "material.glsl"
#include "math.glsl"

// Number of this invocation's crossings of surfaces that closed, disjoint volumes cannot have.
uint volumeFaults = 0u;

// The volume of a ray that was transmitted, if the ray before it was in `volume`.
uint volumeBeyond(Material material, bool outside, uint volume) {
  if (material.volume == 0u) return volume;
  return outside ? material.volume : 0u;
}

void countVolumeFault(Material material, bool outside, uint volume) {
  if (material.volume == 0u) return;
  volumeFaults += volume != (outside ? 0u : material.volume) ? 1u : 0u;
}

// Transmittance of a length of a volume; 1 outside of all volumes.
vec3 volumeTransmittance(uint volume, float distance) {
  if (volume == 0u) return vec3(1.0);
  vec3 depth = loadCoat(volume - 1u).absorption * distance;
  return vec3(exponential(-depth.x), exponential(-depth.y), exponential(-depth.z));
}

#endif
