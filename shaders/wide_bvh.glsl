// Stack traversal of the compressed 8-wide BVH (Ylitie, Karras and Laine, HPG 2017), "while-while" like that of the
// binary one. host/trace/accel/wide_bvh.h describes the nodes, host/trace/accel/quantised_boxes.h explains why the box test loses
// no hit.
#ifndef CANDELA_WIDE_BVH_GLSL
#define CANDELA_WIDE_BVH_GLSL

// A ray in the form that box tests need. As in BoxRay, the part of the boxes' padding that grows with the ray's own
// coordinates is added to the origins.
struct WideRay {
  vec3 origin;
  float padding;
  vec3 inverse;
  bvec3 backward;   // components of the direction that are negative
  uint octant;      // `backward` as bits
  vec3 nearOrigin;  // subtracted from the near planes
  vec3 farOrigin;
};

// The product of a plane's index and an inverse direction must not overflow, because it could cancel against its
// opposite and become NaN. Coordinates are below 2^41, and 2^-80 is still too small to affect a result.
const float kMinComponent = 8.3e-25;

// The members of a ray that follow from others. GPUs compute them for each node, and have registers for more rays.
bvec3 backwardOf(WideRay ray) { return kMasksLanes ? ray.backward : lessThan(ray.inverse, vec3(0.0)); }
vec3 padOf(WideRay ray) { return mix(vec3(1.0), vec3(-1.0), backwardOf(ray)) * ray.padding; }
vec3 nearOriginOf(WideRay ray) { return kMasksLanes ? ray.nearOrigin : ray.origin + padOf(ray); }
vec3 farOriginOf(WideRay ray) { return kMasksLanes ? ray.farOrigin : ray.origin - padOf(ray); }

WideRay wideRay(vec3 origin, vec3 direction, float padding) {
  WideRay result;
  result.origin = origin;
  result.padding = padding;
  result.backward = lessThan(direction, vec3(0.0));
  vec3 magnitude = max(abs(direction), vec3(kMinComponent));
  result.inverse = 1.0 / mix(magnitude, -magnitude, result.backward);
  result.nearOrigin = origin + padOf(result);
  result.farOrigin = origin - padOf(result);
  uvec3 bits = mix(uvec3(0u), uvec3(1u, 2u, 4u), result.backward);
  result.octant = bits.x | bits.y | bits.z;
  return result;
}

float paddingOf(vec3 origin) { return largest(abs(origin)) * (1.0 / 524288.0); }

WideRay wideRay(Ray ray) { return wideRay(ray.origin, ray.direction, paddingOf(ray.origin)); }

// A node's grid of planes in units of the ray's distance.
struct PlaneDistances {
  vec3 step;
  vec3 near;  // of plane 0 as a near plane, and as a far plane
  vec3 far;
};

// A byte of each word. Lanes of a processor convert signed integers faster, GPUs have an instruction for bytes.
vec3 planeIndices(uvec3 words, uint byte) {
  uvec3 indices = (words >> (8u * byte)) & 255u;
  return kMasksLanes ? vec3(ivec3(indices)) : vec3(indices);
}

// Returns bit i for each child i that the ray intersects before `limit`. The words contain the planes of four children
// for each axis.
uint hitOne(uvec3 near, uvec3 far, uint byte, PlaneDistances at, float limit) {
  vec3 t0 = planeIndices(near, byte) * at.step + at.near;
  vec3 t1 = planeIndices(far, byte) * at.step + at.far;
  float entry = larger(larger(t0.x, t0.y), larger(t0.z, 0.0));
  float exit = smaller(smaller(t1.x, t1.y), smaller(t1.z, limit));
  return entry <= exit ? 1u << byte : 0u;
}

uint hitFour(uvec3 near, uvec3 far, PlaneDistances at, float limit) {
  return hitOne(near, far, 0u, at, limit) | hitOne(near, far, 1u, at, limit) | hitOne(near, far, 2u, at, limit) |
         hitOne(near, far, 3u, at, limit);
}

// Returns the index of the lowest bit that is set; of a masked lane, by converting this power of two to a float and
// reading its exponent: docs/driver-workarounds.md section 16. Not for 0 or bit 31.
uint lowestBit(uint bits) {
  if (!kMasksLanes) return uint(findLSB(bits));
  return (floatBitsToUint(float(int(bits & (~bits + 1u)))) >> 23) - 127u;
}

// Moves bit i of eight to i ^ octant: from the order of the children's indices to the order from near to far.
uint fromNearToFar(uint bits, uint octant) {
  uint x = (octant & 1u) == 0u ? bits : ((bits & 0x55u) << 1) | ((bits >> 1) & 0x55u);
  uint y = (octant & 2u) == 0u ? x : ((x & 0x33u) << 2) | ((x >> 2) & 0x33u);
  return (octant & 4u) == 0u ? y : ((y & 0x0fu) << 4) | (y >> 4);
}

// Repeats each of eight bits three times.
uint tripled(uint bits) {
  uint x = (bits | (bits << 8)) & 0x00f00fu;
  x = (x | (x << 4)) & 0x0c30c3u;
  x = (x | (x << 2)) & 0x249249u;
  return x | (x << 1) | (x << 2);
}

// State of the invocation's current traversal. A word states which nodes of a block are pending: the block << 8, and a
// bit for each node, from near to far. If the bits are 0, no node is pending.
uint pendingNodes;
uint left;            // the rest of the block once its nearest node has been visited
uint leafHits;        // bits of the current node's leaf mask whose primitives are still to be tested
uint leafMask;
uint firstPrimitive;
bool nonePending;     // no node of any block is pending
uint wideUnfinished;  // 1 until the traversal ends: docs/driver-workarounds.md section 4

// State of the BVH over instances while one of them is traversed: instances.glsl.
bool insideInstance;
uint stackFloor;  // words on the stack that belong to the outer BVH

// The stack of words below the current block, the last one first, the rest 0. BVHs that need more words use the array
// of bvh.glsl: docs/driver-workarounds.md section 7.
const uint kWordsKept = kMasksLanes ? 12u : 0u;
uvec4 kept0;
uvec4 kept1;
uvec4 kept2;

void startWideTraversal(WideRay ray) {
  stackTop = 0u;
  kept0 = uvec4(0u);
  kept1 = uvec4(0u);
  kept2 = uvec4(0u);
  pendingNodes = 1u << ray.octant;
  leafHits = 0u;
  nonePending = false;
  wideUnfinished = 1u;
  insideInstance = false;
  stackFloor = 0u;
}

bool isTraversed() { return nonePending && leafHits == 0u; }

void noteWideEnd() { wideUnfinished = isTraversed() && !(kHasInstances && insideInstance) ? 0u : 1u; }

// Tests the children of the nearest pending node.
void visitWideNode(WideRay ray, float limit) {
  uint child = lowestBit(pendingNodes & 255u) ^ ray.octant;
  uint row = constants.firstStructureRow + ((pendingNodes >> 8) + child) * kWideNodeRows;
  left = pendingNodes & (pendingNodes - 1u);

  uvec4 head = sceneRow(row);
  uvec4 lowXy = sceneRow(row + 2u);
  uvec4 lowZHighX = sceneRow(row + 3u);
  uvec4 highYz = sceneRow(row + 4u);
  vec3 origin = uintBitsToFloat(head.xyz);
  vec3 step = uintBitsToFloat((uvec3(head.w) << uvec3(23u, 15u, 7u)) & 0x7f800000u);
  PlaneDistances at = PlaneDistances(step * ray.inverse, (origin - nearOriginOf(ray)) * ray.inverse,
                                     (origin - farOriginOf(ray)) * ray.inverse);
  uvec3 low0 = uvec3(lowXy.x, lowXy.z, lowZHighX.x);
  uvec3 low1 = uvec3(lowXy.y, lowXy.w, lowZHighX.y);
  uvec3 high0 = uvec3(lowZHighX.z, highYz.x, highYz.z);
  uvec3 high1 = uvec3(lowZHighX.w, highYz.y, highYz.w);
  bvec3 backward = backwardOf(ray);
  uint hits = hitFour(mix(low0, high0, backward), mix(high0, low0, backward), at, limit) |
              (hitFour(mix(low1, high1, backward), mix(high1, low1, backward), at, limit) << 4);

  uint inner = head.w >> 24;
  uvec4 links = sceneRow(row + 1u);
  leafMask = links.z;
  firstPrimitive = links.y;
  leafHits = tripled(hits & ~inner) & leafMask;
  pendingNodes = (links.x << 8) | fromNearToFar(hits & inner, ray.octant);
}

bool anyPending(uint word) { return (word & 255u) != 0u; }

void nextOfKept() {
  bool deeper = anyPending(pendingNodes) && anyPending(left);
  bool back = !anyPending(pendingNodes) && !anyPending(left);
  if (kHasInstances) {
    back = back && stackTop > stackFloor;
    stackTop += deeper ? 1u : 0u;
    stackTop -= back ? 1u : 0u;
  }
  uvec4 next0 = deeper ? uvec4(left, kept0.xyz) : back ? uvec4(kept0.yzw, kept1.x) : kept0;
  uvec4 next1 = deeper ? uvec4(kept0.w, kept1.xyz) : back ? uvec4(kept1.yzw, kept2.x) : kept1;
  uvec4 next2 = deeper ? uvec4(kept1.w, kept2.xyz) : back ? uvec4(kept2.yzw, 0u) : kept2;
  pendingNodes = anyPending(pendingNodes) ? pendingNodes : back ? kept0.x : left;
  kept0 = next0;
  if (kStackSize > 4u) kept1 = next1;
  if (kStackSize > 8u) kept2 = next2;
}

void nextOfStack() {
  bool deeper = anyPending(pendingNodes) && anyPending(left);
  bool back = !anyPending(pendingNodes) && !anyPending(left) && stackTop > (kHasInstances ? stackFloor : 0u);
  if (deeper) setStackWord(stackTop, left);
  stackTop += deeper ? 1u : 0u;
  stackTop -= back ? 1u : 0u;
  uint top = stackWord(back ? stackTop : 0u);
  pendingNodes = anyPending(pendingNodes) ? pendingNodes : back ? top : left;
}

// Continues with the block of the node's children, else with the rest of its own block, else with the last block on the
// stack.
void nextBlock() {
  if (kStackSize <= kWordsKept) nextOfKept();
  else nextOfStack();
  nonePending = !anyPending(pendingNodes);
}

void descendToLeaves(WideRay ray, float limit, inout Work work) {
  while (leafHits == 0u && !nonePending) {
    visitWideNode(ray, limit);
    nextBlock();
    noteWideEnd();
    work.steps += 1u;
    if (kMasksLanes && (leafHits != 0u || nonePending)) break;
  }
}

// Returns the slot of the next primitive to test.
uint takeLeafHit() {
  uint bit = lowestBit(leafHits);
  leafHits &= leafHits - 1u;
  noteWideEnd();
  return firstPrimitive + uint(bitCount(leafMask & ((1u << bit) - 1u)));
}

void closestInWideHierarchy(inout Hit hit, Ray ray, inout Work work) {
  WideRay wide = wideRay(ray);
  startWideTraversal(wide);
  while (!nonePending || leafHits != 0u) {
    descendToLeaves(wide, hit.t, work);
    while (leafHits != 0u) {
      uint slot = takeLeafHit();
      keepCloser(hit, hitPrimitive(ray, slot, kFinitePrimitive), slot, 0u);
      work.steps += 1u;
      if (kMasksLanes && leafHits == 0u) break;
    }
    if (kMasksLanes && nonePending) break;
  }
  work.truncated += wideUnfinished;
}

// Returns the ray, which compilers cannot know: in scenes with instances, GPUs compute the WideRay of the outer BVH again
// rather than keep it in registers while they are inside an instance. A stack has less than 2^31 entries.
Ray sameRay(Ray ray) {
  if (kMasksLanes || !kHasInstances) return ray;
  uvec3 zero = uvec3(stackTop >> 31);
  ray.origin = uintBitsToFloat(floatBitsToUint(ray.origin) | zero);
  ray.direction = uintBitsToFloat(floatBitsToUint(ray.direction) | zero);
  return ray;
}

bool anyInWideHierarchy(Ray ray, RayEnd end, inout Work work) {
  WideRay wide = wideRay(sameRay(ray));
  bool blocked = false;
  startWideTraversal(wide);
  while ((!nonePending || leafHits != 0u) && !blocked) {
    descendToLeaves(wide, end.distance, work);
    while (leafHits != 0u && !blocked) {
      uint slot = takeLeafHit();
      blocked = occludes(ray, slot, end, kFinitePrimitive);
      work.steps += 1u;
      if (kMasksLanes && (leafHits == 0u || blocked)) break;
    }
    if (kMasksLanes && (nonePending || blocked)) break;
  }
  work.truncated += blocked ? 0u : wideUnfinished;
  return blocked;
}

#endif
