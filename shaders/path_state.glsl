// Packing of a path that is stored in a buffer between two dispatches, and access to the packed members.
#ifndef CANDELA_PATH_STATE_GLSL
#define CANDELA_PATH_STATE_GLSL
#include "path.glsl"
#include "shared/render_data.h"

// Members of a PathState and of a WaveState by name. These are macros, because a function would copy the whole state
// from its buffer, and its result could not be assigned to.
#define sampleIndexOf(pathState) pathState.radianceSample.w
#define depthOf(pathState) (pathState.throughputDepth.w & kDepthMask)
#define radianceBitsOf(pathState) pathState.radianceSample.xyz
#define hitOf(waveState) waveState.hit.xyz
#define lightPointOf(waveState) waveState.hit.xyz  // the shaded hit is no longer needed
#define shadedDepthOf(waveState) waveState.hit.w

const uint kDepthMask = (1u << kVolumeShift) - 1u;

Path unpackPath(PathState state) {
  Path path;
  path.ray = makeRay(uintBitsToFloat(state.originPdf.xyz), uintBitsToFloat(state.directionAndSlot.xyz),
                     state.directionAndSlot.w);
  path.ray.originInstance = state.instances.x;
  path.pdf = uintBitsToFloat(state.originPdf.w);
  path.throughput = uintBitsToFloat(state.throughputDepth.xyz);
  path.depth = depthOf(state);
  path.receiver = kHasLightTree ? state.instances.w : 0u;
  path.volume = state.throughputDepth.w >> kVolumeShift;
  path.radiance = uintBitsToFloat(radianceBitsOf(state));
  return path;
}

PathState packPath(Path path, uint sampleIndex, PathCounts counts) {
  return PathState(floatBitsToUint(vec4(path.ray.origin, path.pdf)),
                   uvec4(floatBitsToUint(path.ray.direction), path.ray.originSlot),
                   uvec4(floatBitsToUint(path.throughput), path.depth | (kHasVolumes ? path.volume << kVolumeShift : 0u)),
                   uvec4(floatBitsToUint(path.radiance), sampleIndex), counts,
                   uvec4(path.ray.originInstance, 0u, 0u, kHasLightTree ? path.receiver : 0u));
}

// Packs decisions into the format of path records.
uvec2 packDecisions(Decisions decisions) {
  uint survived = decisions.survived ? 1u << 16 : 0u;
  return uvec2(decisions.index, kRecordValid | survived | (decisions.shadow << 8) | decisions.lobe);
}

#endif
