// Packing of a path that is stored in a buffer between two dispatches, and access to the packed members.
#ifndef CANDELA_PATH_STATE_GLSL
#define CANDELA_PATH_STATE_GLSL
#include "path.glsl"
#include "shared/render_data.h"

Path unpackPath(PathState state) {
  Path path;
  path.ray = makeRay(uintBitsToFloat(state.originPdf.xyz), uintBitsToFloat(state.directionLeaving.xyz),
                     state.directionLeaving.w);
  path.pdf = uintBitsToFloat(state.originPdf.w);
  path.throughput = uintBitsToFloat(state.throughputDepth.xyz);
  path.depth = state.throughputDepth.w;
  path.radiance = uintBitsToFloat(state.radianceSample.xyz);
  return path;
}

PathState packPath(Path path, uint sampleIndex, PathCounts counts) {
  return PathState(floatBitsToUint(vec4(path.ray.origin, path.pdf)),
                   uvec4(floatBitsToUint(path.ray.direction), path.ray.leaving),
                   uvec4(floatBitsToUint(path.throughput), path.depth),
                   uvec4(floatBitsToUint(path.radiance), sampleIndex), counts);
}

// Packs decisions into the format of path records.
uvec2 packDecisions(Decisions decisions) {
  uint survived = decisions.survived ? 1u << 16 : 0u;
  return uvec2(decisions.index, kRecordValid | survived | (decisions.shadow << 8) | decisions.lobe);
}

#endif
