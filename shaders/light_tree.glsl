// The choice of a light by a tree: docs/light-transport.md section 6.1.
#ifndef CANDELA_LIGHT_TREE_GLSL
#define CANDELA_LIGHT_TREE_GLSL
#include "math.glsl"
#include "sampler.glsl"
#include "scene_access.glsl"

// The point for which a light is chosen, and what its surface receives.
struct LightReceiver {
  vec3 position;
  vec3 normal;
  bool transmits;  // its material can scatter light to the other side
  float slack;     // for the rounding of the normal
};

const uint kReceiverTransmits = 1u << 30;
const float kNormalSlack = 1.0 / 2048.0;
const float kMinBranch = 1.0 / 65536.0;
const float kTwoTo32 = 4294967296.0;
const uint kMaxTreeDepth = 31u;

struct LightNode {
  vec3 centre;
  float radius;
  float power;
  uint axis;  // stored direction and flags
  float cosine;
  uint next;
};

vec2 folded(vec2 p) { return (1.0 - abs(p.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(p, vec2(0.0))); }

uint packDirection(vec3 v) {
  vec2 p = v.xy / (abs(v.x) + abs(v.y) + abs(v.z));
  uvec2 steps = uvec2(floor(8192.0 * ((v.z < 0.0 ? folded(p) : p) + 1.0) + 0.5));
  return steps.x | steps.y << kDirectionBits;
}

vec3 unpackDirection(uint word) {
  uvec2 steps = uvec2(word & kDirectionMask, word >> kDirectionBits & kDirectionMask);
  vec2 p = vec2(steps) * (1.0 / 8192.0) - 1.0;
  float z = 1.0 - abs(p.x) - abs(p.y);
  return unit(vec3(z < 0.0 ? folded(p) : p, z));
}

// Returns the receiver at a point with the word of a stored normal and kReceiverTransmits.
LightReceiver receiverAt(vec3 position, uint word) {
  return LightReceiver(position, unpackDirection(word), (word & kReceiverTransmits) != 0u, kNormalSlack);
}

// Returns a receiver in the space of the mesh of an instance that emits, whose first record is `row`.
LightReceiver placedReceiver(LightReceiver receiver, uint row) {
  vec4 columns[3] = vec4[3](sceneRowFloat(row), sceneRowFloat(row + 1u), sceneRowFloat(row + 2u));
  vec4 inverse[3] = vec4[3](sceneRowFloat(row + 3u), sceneRowFloat(row + 4u), sceneRowFloat(row + 5u));
  vec3 offset = receiver.position - vec3(columns[0].w, columns[1].w, columns[2].w);
  receiver.position = vec3(dot(inverse[0].xyz, offset), dot(inverse[1].xyz, offset), dot(inverse[2].xyz, offset));
  vec3 normal = receiver.normal;
  receiver.normal = unit(vec3(dot(columns[0].xyz, normal), dot(columns[1].xyz, normal), dot(columns[2].xyz, normal)));
  receiver.slack = inverse[0].w;
  return receiver;
}

uint sceneWord(uint word) { return sceneRow(word >> 2)[word & 3u]; }

// A tree that is walked.
struct LightNodes {
  uint firstRow;  // of the nodes
  uint leaves;
  uint dimensions;  // of its random numbers at vertex 1
};

// `index` counts leaves, or with `isLeaf` false, inner nodes.
LightNode loadLightNode(uint index, bool isLeaf, LightNodes nodes) {
  uint row = nodes.firstRow + kLightNodeRows * (isLeaf ? index : nodes.leaves + index);
  vec4 bounds = sceneRowFloat(row);
  uvec4 rest = sceneRow(row + 1u);
  return LightNode(bounds.xyz, bounds.w, uintBitsToFloat(rest.x), rest.y, uintBitsToFloat(rest.z), rest.w);
}

// Returns the cosine and the sine of max(0, s - t), for the cosines and sines of two angles.
vec2 angleBeyond(vec2 s, vec2 t) {
  if (s.x >= t.x) return vec2(1.0, 0.0);
  return vec2(s.x * t.x + s.y * t.y, s.y * t.x - s.x * t.y);
}

vec2 withSine(float cosine) { return vec2(cosine, sqrt(max(0.0, 1.0 - cosine * cosine))); }

float lightImportance(LightNode node, LightReceiver receiver) {
  vec3 toPoint = receiver.position - node.centre;
  float squared = dot(toPoint, toPoint);
  float radiusSquared = node.radius * node.radius;
  float importance = node.power / max(max(squared, radiusSquared), 5.421010862427522e-20);  // 2^-64
  if (squared <= radiusSquared) return importance;
  float inverse = 1.0 / sqrt(squared);
  vec3 w = toPoint * inverse;
  float sine = min(node.radius * inverse, 1.0);
  vec2 spread = vec2(sqrt(1.0 - sine * sine), sine);
  float towards = dot(unpackDirection(node.axis), w);
  if ((node.axis & kLightNodeTwoSided) != 0u) towards = abs(towards);
  vec2 emitted = angleBeyond(angleBeyond(withSine(towards), withSine(node.cosine)), spread);
  if (emitted.x < ((node.axis & kLightNodeCosine) != 0u ? 0.0 : 1.0)) return 0.0;
  float against = -dot(receiver.normal, w);
  if (receiver.transmits) against = abs(against);
  float slack = kHasLightInstances ? receiver.slack : kNormalSlack;
  float received = angleBeyond(withSine(against), spread).x + slack;
  return importance * emitted.x * max(0.0, received);
}

// The two nodes below an inner node, and the number of words, of 2^32, that choose the left one.
struct LightBranch {
  LightNode left;
  LightNode right;
  bool leftIsLeaf;
  bool rightIsLeaf;
  bool leftAlone;  // all 2^32 words
  uint threshold;
};

LightBranch branchBelow(LightNode node, LightNodes nodes, LightReceiver receiver) {
  uint middle = node.next & kLightNodeMask;
  LightBranch branch;
  branch.leftIsLeaf = (node.next & kLightNodeLeftLeaf) != 0u;
  branch.rightIsLeaf = (node.next & kLightNodeRightLeaf) != 0u;
  branch.left = loadLightNode(middle - 1u, branch.leftIsLeaf, nodes);
  branch.right = loadLightNode(middle, branch.rightIsLeaf, nodes);
  float left = lightImportance(branch.left, receiver);
  float right = lightImportance(branch.right, receiver);
  if (!(left > 0.0) && !(right > 0.0)) {
    left = branch.left.power;
    right = branch.right.power;
  }
  branch.leftAlone = left > 0.0 && !(right > 0.0);
  float part = clamp(left / (left + right), kMinBranch, 1.0 - kMinBranch);
  branch.threshold = left > 0.0 ? uint(part * kTwoTo32) : 0u;
  return branch;
}

float branchProbability(LightBranch branch, bool right) {
  if (branch.leftAlone) return right ? 0.0 : 1.0;
  if (branch.threshold == 0u) return right ? 1.0 : 0.0;
  return float(right ? 0u - branch.threshold : branch.threshold) * (1.0 / kTwoTo32);
}

struct LightChoice {
  uint light;         // entry of the light table; of the tree of a mesh, the triangle
  float probability;
};

// Walks down from the root. With `followsTrail`, to the light of this trail, whose probability is wanted; otherwise, by the random
// numbers of vertex `depth`. `probability`: of the tree.
LightChoice walkNodes(LightNodes nodes, float probability, LightReceiver receiver, bool followsTrail, uint trail,
                      SampleKey key, uint depth, inout uint truncated) {
  bool isLeaf = nodes.leaves == 1u;
  LightNode node = loadLightNode(0u, isLeaf, nodes);
  uint group = (nodes.dimensions + (depth - 1u) * kLightTreeDimensionCount) / kGroupSize;
  uvec4 numbers = uvec4(0u);
  uint level = 0u;
  uint cutShort = isLeaf ? 0u : 1u;  // docs/driver-workarounds.md section 4
  while (!isLeaf && level < kMaxTreeDepth) {
    LightBranch branch = branchBelow(node, nodes, receiver);
    if (!followsTrail && level % kGroupSize == 0u) numbers = sampleGroup(key, group + level / kGroupSize);
    bool right = followsTrail ? (trail >> level & 1u) != 0u
                              : !branch.leftAlone && numbers[level % kGroupSize] >= branch.threshold;
    probability *= branchProbability(branch, right);
    isLeaf = right ? branch.rightIsLeaf : branch.leftIsLeaf;
    if (right) node = branch.right;
    else node = branch.left;
    ++level;
    cutShort = isLeaf ? 0u : 1u;
    if (kMasksLanes && isLeaf) break;
  }
  truncated += cutShort;
  return LightChoice(node.next, probability);
}

LightChoice walkLightTree(LightReceiver receiver, bool followsTrail, uint trail, SampleKey key, uint depth,
                          inout uint truncated) {
  uint row = constants.firstLightTreeRow;
  uvec4 header = sceneRow(row);
  LightNodes nodes = LightNodes(row + kLightTreeHeaderRows, header.z, kLightTreeDimensions);
  return walkNodes(nodes, uintBitsToFloat(header.y), receiver, followsTrail, trail, key, depth, truncated);
}

// Walks below the leaf of an instance that emits, whose first record is `row` and whose probability is `probability`. `triangle`:
// with `followsTrail`, the number in its mesh.
LightChoice walkMeshTree(uint row, float probability, LightReceiver receiver, bool followsTrail, uint triangle,
                         SampleKey key, uint depth, inout uint truncated) {
  uint tree = sceneRow(row + 4u).w;
  uvec4 header = sceneRow(tree);
  uint trail = followsTrail ? sceneWord(header.y + triangle) : 0u;
  if (followsTrail && trail == kNoTrail) return LightChoice(triangle, 0.0);
  LightNodes nodes = LightNodes(tree + kLightTreeHeaderRows, header.z, kMeshTreeDimensions);
  return walkNodes(nodes, probability, placedReceiver(receiver, row), followsTrail, trail, key, depth, truncated);
}

// Returns the slot of a triangle of an instance that emits.
uint slotOfTriangle(uint row, uint triangle) { return sceneWord(sceneRow(row + 5u).w + triangle); }

#endif
