// Entry point of the Whitted tracer: one invocation per pixel. When its tree is done, an invocation starts the pixel's
// next sample at once. When it reaches its maximum number of rays or loop iterations, it stores its tree in a buffer
// and continues in the next dispatch.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "dispatch.glsl"
#include "whitted.glsl"

layout(set = 0, binding = kBindingPathStates, std430) buffer TreeStates { uvec4 treeRows[]; };
layout(set = 0, binding = kBindingResults, std430) buffer Results {
  Counters counters;
  uvec2 records[];
};

TreeState loadTree(uint row) {
  uvec4 position = treeRows[row + 2u];
  uvec4 rays = treeRows[row + 4u];
  uvec4 work = treeRows[row + 5u];
  return TreeState(treeRows[row], treeRows[row + 1u], position.x, position.y, position.z, position.w, treeRows[row + 3u], rays.x,
                   rays.y, rays.z, rays.w, work.x, work.y, work.z, 0u);
}

void storeTree(uint row, TreeState state) {
  treeRows[row] = state.originAndSlot;
  treeRows[row + 1u] = state.directionWeight;
  treeRows[row + 2u] = uvec4(state.node, state.pending, state.nextLight, state.nodesDone);
  treeRows[row + 3u] = state.radianceSample;
  treeRows[row + 4u] = uvec4(state.cameraHits, state.reflectedRays, state.refractedRays, state.shadowRays);
  treeRows[row + 5u] = uvec4(state.vertices, state.steps, state.originInstance, 0u);
}

Ray unpackRay(uvec4 originAndSlot, uvec4 directionWeight, uint instance) {
  Ray ray = makeRay(uintBitsToFloat(originAndSlot.xyz), uintBitsToFloat(directionWeight.xyz), originAndSlot.w);
  ray.originInstance = instance;
  return ray;
}

Tree unpackTree(TreeState state) {
  return Tree(unpackRay(state.originAndSlot, state.directionWeight, state.originInstance), uintBitsToFloat(state.directionWeight.w),
              state.node, state.pending, state.nextLight, uintBitsToFloat(state.radianceSample.xyz));
}

uint pendingRow(uint treeRow, uint depth) { return treeRow + kTreeRows + (depth - 2u) * kPendingRows; }

void storePending(inout Tree tree, uint treeRow, uint depth, Ray ray, float weight) {
  uint row = pendingRow(treeRow, depth);
  treeRows[row] = uvec4(floatBitsToUint(ray.origin), ray.originSlot);
  treeRows[row + 1u] = floatBitsToUint(vec4(ray.direction, weight));
  if (kHasInstances) treeRows[row + 2u].x = ray.originInstance;
  tree.pending |= 1u << depth;
}

// Makes the deepest pending ray current. It is the sibling of a reflected ray on the way from the root to `node`.
void takePending(inout Tree tree, uint treeRow) {
  uint depth = uint(findMSB(tree.pending));
  uint row = pendingRow(treeRow, depth);
  uvec4 originAndSlot = treeRows[row];
  uvec4 directionWeight = treeRows[row + 1u];
  tree.ray = unpackRay(originAndSlot, directionWeight, kHasInstances ? treeRows[row + 2u].x : 0u);
  tree.weight = uintBitsToFloat(directionWeight.w);
  tree.node = (tree.node >> (depthOf(tree.node) - depth)) | 1u;
  tree.pending ^= 1u << depth;
}

// Goes to the next node: the reflected child, else the deepest pending ray. Returns true if there is one.
bool followBranches(inout Tree tree, uint treeRow, Surface surface, Branches branches, inout RayCounts counts) {
  float weight = tree.weight;
  tree.nextLight = 0u;
  tree.node *= 2u;
  if (kHasDielectric && branches.refractedFactor > 0.0) {
    counts.refracted += 1u;
    storePending(tree, treeRow, depthOf(tree.node), rayFrom(surface, branches.refracted, true),
                 weight * branches.refractedFactor);
  }
  bool reflects = (kHasMirror || kHasDielectric) && branches.reflectedFactor > 0.0;
  if (reflects) {
    counts.reflected += 1u;
    tree.ray = rayFrom(surface, branches.reflected, false);
    tree.weight = weight * branches.reflectedFactor;
    return true;
  }
  bool hasPending = kHasDielectric && tree.pending != 0u;
  if (hasPending) takePending(tree, treeRow);
  return hasPending;
}

// Records a node's decisions. A node whose lights take several segments adds to its record.
void record(uint pixelIndex, uint number, Decisions decisions) {
  if (number >= kRecordedVertices) return;
  uint index = pixelIndex * kRecordedVertices + number;
  uint before = records[index].y;
  uint visible = ((before & ~kRecordValid) >> kRecordLightShift) ^ decisions.visibleLights;
  uint shadow = max((before >> 8) & 255u, decisions.shadow);
  uint flags = kRecordValid | (visible << kRecordLightShift) | (1u << 16) | (shadow << 8) | decisions.lobe;
  records[index] = uvec2(decisions.index, flags);
}

void main() {
  uvec2 inRegion = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(inRegion, dispatch.regionSize))) return;
  uvec2 pixel = dispatch.regionOrigin + inRegion;
  uint pixelIndex = pixelIndexOf(pixel);
  uint treeRow = pixelIndex * constants.stateRows;
  TreeState state = loadTree(treeRow);
  uint firstSample = state.radianceSample.w;
  uint sampleIndex = firstSample;
  uint sampleEnd = dispatch.sampleEnd;
  if (sampleIndex >= sampleEnd) return;

  Tree tree = unpackTree(state);
  FilmRows sums = film[pixelIndex];
  RayCounts counts = RayCounts(state.cameraHits, state.reflectedRays, state.refractedRays, state.shadowRays, state.vertices);
  Work work = Work(0u, 0u);
  uint nodesDone = state.nodesDone;
  uint segments = 0u;
  uint lightTurns = 0u;
  bool working = true;
  uint cutShort = 1u;  // docs/driver-workarounds.md section 4
  while (working) {
    SampleKey key = sampleKeyOf(pixel, sampleIndex);
    if (tree.node == 0u) startTree(tree, key, pixel);
    Decisions decisions;
    Surface surface;
    Branches branches;
    bool nodeDone = visitNode(tree, key, work, counts, decisions, surface, branches);
    if (kRecordPaths) record(pixelIndex, nodesDone, decisions);
    bool treeDone = nodeDone && !followBranches(tree, treeRow, surface, branches, counts);
    nodesDone += nodeDone ? 1u : 0u;
    if (treeDone) {
      addSample(sums, tree.radiance, sampleIndex);
      tree.node = 0u;
      nodesDone = 0u;
      sampleIndex += 1u;
    }
    segments += 1u;
    lightTurns += min(constants.lightCount, kLightsPerSegment);
    working = sampleIndex < sampleEnd && segments < dispatch.maxSegments &&
              work.steps + segments + lightTurns < dispatch.maxIterations;
    cutShort = working ? 1u : 0u;
    if (kMasksLanes && !working) break;
  }
  uint truncated = kLimitsLoops ? work.truncated + cutShort : 0u;
  film[pixelIndex] = sums;
  storeTree(treeRow, TreeState(uvec4(floatBitsToUint(tree.ray.origin), tree.ray.originSlot),
                               floatBitsToUint(vec4(tree.ray.direction, tree.weight)),
                               tree.node, tree.pending, tree.nextLight, nodesDone,
                               uvec4(floatBitsToUint(tree.radiance), sampleIndex), counts.cameraHits, counts.reflected,
                               counts.refracted, counts.shadow, counts.vertices, state.steps + work.steps, tree.ray.originInstance, 0u));
  if (truncated > 0u) atomicAdd(counters.truncated, truncated);
  if (sampleIndex > firstSample) atomicAdd(counters.finishedSamples, sampleIndex - firstSample);
  if (sampleIndex >= sampleEnd) atomicAdd(counters.finishedPixels, 1u);
}
