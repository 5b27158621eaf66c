// Stack traversal of the binary BVH, "while-while" (Aila and Laine, HPG 2009): all invocations descend to a leaf, then
// all test primitives.
#ifndef CANDELA_BVH_GLSL
#define CANDELA_BVH_GLSL
#include "stack.glsl"

// A subtree that is pending or current. If count is 0, `reference` is an interior node; otherwise it is the first of
// `count` slots.
struct Subtree {
  uint reference;
  uint count;
};

// A ray in the form that box tests need. Boxes are padded by the error of primitive tests relative to the primitive's
// size; the part of the error that grows with the ray's own coordinates is added to the origin
// (host/trace/accel/primitive_bounds.h).
struct BoxRay {
  vec3 lowOrigin;   // subtracted from the boxes' lower corners
  vec3 highOrigin;
  vec3 inverse;
};

BoxRay boxRay(Ray ray) {
  float pad = largest(abs(ray.origin)) * (1.0 / 524288.0);
  return BoxRay(ray.origin + pad, ray.origin - pad, inverseDirection(ray.direction));
}

// Returns the distance at which the ray enters a child's box, or kNoHit. The far distance is widened by 1 + 2 gamma(3)
// (Ize, JCGT 2013).
float boxEntry(vec3 low, vec3 high, BoxRay ray, float limit) {
  vec3 t0 = (low - ray.lowOrigin) * ray.inverse;
  vec3 t1 = (high - ray.highOrigin) * ray.inverse;
  vec3 near = min(t0, t1);
  vec3 far = max(t0, t1);
  float entry = max(max(near.x, near.y), max(near.z, 0.0));
  float exit = min(min(far.x, far.y), min(far.z, limit)) * 1.0000004;
  return entry <= exit ? entry : kNoHit;
}

// Packs a subtree into one stack word: slots and nodes are below 2^27, a leaf holds at most 31 primitives.
uint packSubtree(Subtree tree) { return tree.reference | (tree.count << 27); }
Subtree unpackSubtree(uint word) { return Subtree(word & 0x07ffffffu, word >> 27); }

// State of the invocation's current traversal, besides its stack.
Subtree current;
bool finished;
uint unfinished;  // 1 until the traversal ends: docs/driver-workarounds.md section 4

void startTraversal() {
  stackTop = 0u;
  current = Subtree(0u, 0u);
  finished = false;
  unfinished = 1u;
}

// Makes the pending subtree on top of the stack current, or finishes the traversal if none is pending.
void popSubtree() {
  finished = stackTop == 0u;
  unfinished = finished ? 0u : 1u;
  stackTop -= finished ? 0u : 1u;
  Subtree next = unpackSubtree(stackWord(stackTop));
  if (!finished) current = next;
}

// Makes the nearer of the children that the ray intersects before `limit` current, and pushes the other onto the stack.
void visitNode(BoxRay ray, float limit) {
  uint row = constants.firstStructureRow + current.reference * kNodeRows;
  uvec4 leftLow = sceneRow(row);
  uvec4 leftHigh = sceneRow(row + 1u);
  uvec4 rightLow = sceneRow(row + 2u);
  uvec4 rightHigh = sceneRow(row + 3u);
  float left = boxEntry(uintBitsToFloat(leftLow.xyz), uintBitsToFloat(leftHigh.xyz), ray, limit);
  float right = boxEntry(uintBitsToFloat(rightLow.xyz), uintBitsToFloat(rightHigh.xyz), ray, limit);
  bool leftFirst = left <= right;
  Subtree leftTree = Subtree(leftLow.w, leftHigh.w);
  Subtree rightTree = Subtree(rightLow.w, rightHigh.w);
  if (max(left, right) < kNoHit) {
    Subtree later = rightTree;
    if (!leftFirst) later = leftTree;
    setStackWord(stackTop, packSubtree(later));
    ++stackTop;
  }
  if (min(left, right) < kNoHit) {
    current = leftTree;
    if (!leftFirst) current = rightTree;
  } else {
    popSubtree();
  }
}

void descendToLeaf(BoxRay ray, float limit, inout Work work) {
  while (!finished && current.count == 0u) {
    visitNode(ray, limit);
    work.steps += 1u;
    if (kMasksLanes && (finished || current.count != 0u)) break;
  }
  work.truncated += current.count == 0u ? unfinished : 0u;
}

void closestInHierarchy(inout Hit hit, Ray ray, inout Work work) {
  BoxRay boxes = boxRay(ray);
  startTraversal();
  while (!finished) {
    descendToLeaf(boxes, hit.t, work);
    if (!finished) {
      closestInRange(hit, ray, current.reference, current.reference + current.count, kFinitePrimitive, work);
      popSubtree();
    }
    if (kMasksLanes && finished) break;
  }
  work.truncated += unfinished;
}

bool anyInHierarchy(Ray ray, RayEnd end, inout Work work) {
  BoxRay boxes = boxRay(ray);
  bool blocked = false;
  startTraversal();
  while (!finished && !blocked) {
    descendToLeaf(boxes, end.distance, work);
    if (!finished) {
      blocked = anyInRange(ray, current.reference, current.reference + current.count, end, kFinitePrimitive, work);
      popSubtree();
    }
    if (kMasksLanes && (finished || blocked)) break;
  }
  work.truncated += blocked ? 0u : unfinished;
  return blocked;
}

#endif
