// Whitted's ray tracer, one ray of the tree at a time: docs/light-transport.md section 9. A tree lives in a Tree between
// rays, so that it can stop after any of them and go on in another dispatch as if it had not.
#ifndef CANDELA_WHITTED_GLSL
#define CANDELA_WHITTED_GLSL
#include "background.glsl"
#include "camera.glsl"
#include "fresnel.glsl"
#include "material.glsl"
#include "normals.glsl"
#include "traversal.glsl"

struct Tree {
  Ray ray;         // at hand
  float weight;    // of what it sees in the pixel
  uint node;       // 1: the camera's ray; n reflects 2n and refracts 2n + 1. 0: the sample has not begun
  uint waiting;    // bit d: the refracted ray of depth d, beside the way to `node`, waits
  uint nextLight;  // of this node, whose lights before it are done
  vec3 radiance;
};

// The rays that go on from a node, and their factors; 0: there is none.
struct Branches {
  vec3 reflected;
  float reflectedFactor;
  vec3 refracted;
  float refractedFactor;
};

const Branches kNoBranches = Branches(vec3(0.0), 0.0, vec3(0.0), 0.0);

// What a node decided, for comparison with another tracer.
struct Decisions {
  uint index;
  uint lobe;
  uint shadow;
  uint visibleLights;
};

struct RayCounts {
  uint cameraHits;
  uint reflected;
  uint refracted;
  uint shadow;
  uint vertices;
};

uint depthOf(uint node) { return uint(findMSB(node)) + 1u; }

void startTree(inout Tree tree, SampleKey key, uvec2 pixel) {
  vec3 origin, direction;
  cameraRay(pixel, toUnit(sampleGroup(key, 0u)), origin, direction);
  tree.ray = makeRay(origin, direction, kNoSlot);
  tree.weight = 1.0;
  tree.node = 1u;
  tree.waiting = 0u;
  tree.nextLight = 0u;
  tree.radiance = vec3(0.0);
}

// The point of a light that a node looks at; words are its light u and light v.
vec3 lightPoint(PointLight light, uint number, uvec2 words) {
  if (!kHasAreaLights) return light.position;
  uvec2 turned = words + number * 0x9e3779b9u;
  return light.position + ((toUnit(turned.x) - 0.5) * light.edgeU + (toUnit(turned.y) - 0.5) * light.edgeV);
}

// (N.H)^Shine, from the sine, which keeps its relative accuracy at the highlight's peak.
float highlight(vec3 normal, vec3 wo, vec3 wi, float shine) {
  vec3 across = cross(normal, unit(wo + wi));
  float sinSquared = min(dot(across, across), 1.0 - 1.0 / 16777216.0);
  return exponential(0.5 * shine * logOneMinus(sinSquared));
}

vec3 localColour(Material m, Normals normals, vec3 wo, vec3 wi) {
  vec3 colour = m.diffuse * (m.diffuseWeight * dot(normals.shading, wi));
  if (kHasGlossy && m.glossyWeight > 0.0) {
    colour += m.glossy * (m.glossyWeight * highlight(normals.shading, wo, wi, m.exponent));
  }
  return colour;
}

// What one light shows at a surface.
vec3 lightShown(PointLight light, vec3 place, Surface surface, Normals normals, Material material, vec3 wo, inout Work work,
                inout uint shadow) {
  vec3 toLight = place - surface.position;
  float distance = sqrt(dot(toLight, toLight));
  precise vec3 wi = toLight / distance;
  bool faces = distance > 0.0 && dot(normals.shading, wi) > 0.0 && dot(normals.geometric, wi) > 0.0;
  shadow = kShadowNotTraced;
  if (!faces) return vec3(0.0);
  bool occluded = traceAny(rayFrom(surface, wi), kNoSlot, distance, work);
  shadow = occluded ? kShadowOccluded : kShadowVisible;
  return occluded ? vec3(0.0) : light.colour * localColour(material, normals, wo, wi);
}

// What the next lights, kLightsPerSegment of them at most, show at a node.
vec3 directLight(inout Tree tree, SampleKey key, Surface surface, Normals normals, Material material, inout Work work,
                 inout RayCounts counts, inout Decisions decisions) {
  uvec2 words = uvec2(0u);
  if (kHasAreaLights) words = sampleGroup(key, vertexGroup(tree.node, kDimensionLightU)).yz;
  vec3 wo = -tree.ray.direction;
  vec3 sum = vec3(0.0);
  uint end = min(constants.lightCount, tree.nextLight + kLightsPerSegment);
  uint cutShort = tree.nextLight < end ? 1u : 0u;  // docs/driver-workarounds.md section 4
  while (tree.nextLight < end) {
    PointLight light = loadPointLight(tree.nextLight);
    uint shadow;
    sum += lightShown(light, lightPoint(light, tree.nextLight, words), surface, normals, material, wo, work, shadow);
    counts.shadow += shadow != kShadowNotTraced ? 1u : 0u;
    decisions.shadow = max(decisions.shadow, shadow);
    decisions.visibleLights ^= shadow == kShadowVisible ? 1u << (tree.nextLight % kRecordedLights) : 0u;
    tree.nextLight += 1u;
    cutShort = tree.nextLight < end ? 1u : 0u;
    if (tree.nextLight >= end) break;
  }
  work.truncated += cutShort;
  return sum;
}

// The rays of a smooth boundary. (wo + n wt) is along the normal, where wt is the refracted direction and n the relative
// index: so wt is along (c - g) N - wo.
Branches glassBranches(Normals normals, vec3 wo, float ior) {
  float c = dot(normals.shading, wo);
  float g;
  float reflectance = fresnelReflectance(c, normals.outside ? ior : 1.0 / ior, g);
  precise vec3 reflected = unit(2.0 * c * normals.shading - wo);
  precise vec3 refracted = unit((c - g) * normals.shading - wo);
  return Branches(reflected, reflectance, refracted, 1.0 - reflectance);
}

Branches mirrorBranches(Normals normals, vec3 wo, float ks) {
  precise vec3 reflected = unit(2.0 * dot(normals.shading, wo) * normals.shading - wo);
  return Branches(reflected, ks, vec3(0.0), 0.0);
}

// Rays that end up on the wrong side of the geometric normal are not there.
Branches branchesAt(Normals normals, Material material, vec3 wo) {
  Branches branches = kNoBranches;
  if (kHasMirror && material.mirror) branches = mirrorBranches(normals, wo, material.glossyWeight);
  if (kHasDielectric && material.dielectricWeight > 0.0) branches = glassBranches(normals, wo, material.ior);
  if (dot(branches.reflected, normals.geometric) <= 0.0) branches.reflectedFactor = 0.0;
  if (dot(branches.refracted, normals.geometric) >= 0.0) branches.refractedFactor = 0.0;
  return branches;
}

bool isSound(vec3 direction, float factor) { return factor == 0.0 || isFinite(factor * dot(direction, vec3(1.0))); }

uint lobeOf(Branches branches, Material material) {
  if (branches.refractedFactor > 0.0) return kLobeRefract;
  if (branches.reflectedFactor > 0.0) return material.mirror ? kLobeMirror : kLobeReflect;
  return kLobeNone;
}

// Traces the ray at hand and shades what it meets. True if the node is done, and its branches are to be followed; else
// some of its lights are left.
bool visitNode(inout Tree tree, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions,
               out Surface surface, out Branches branches) {
  decisions = Decisions(kRecordMiss, kLobeNone, kShadowNotTraced, 0u);
  branches = kNoBranches;
  bool first = tree.nextLight == 0u;
  Hit hit = traceClosest(tree.ray, work);
  if (hit.t >= kNoHit) {
    tree.radiance += tree.weight * backgroundRadiance(tree.ray.direction);
    return true;
  }
  decisions.index = hit.index;
  counts.vertices += first ? 1u : 0u;
  counts.cameraHits += first && tree.node == 1u ? 1u : 0u;
  surface = surfaceAt(tree.ray, hit.slot, hit.t);
  Material material = materialAt(surface);
  vec3 wo = -tree.ray.direction;
  Normals normals = normalsTowards(surface, wo);
  if (kHasEmission && first) tree.radiance += tree.weight * material.emission;
  if (kHasPointLights && material.diffuseWeight + material.glossyWeight > 0.0) {
    tree.radiance += tree.weight * directLight(tree, key, surface, normals, material, work, counts, decisions);
    if (tree.nextLight < constants.lightCount) return false;
  }
  if (depthOf(tree.node) < constants.maxDepth) branches = branchesAt(normals, material, wo);
  // What is not finite must not be lost in silence: the film counts it as a bad sample.
  bool sound = isSound(branches.reflected, branches.reflectedFactor) && isSound(branches.refracted, branches.refractedFactor);
  if (!sound) tree.radiance = vec3(uintBitsToFloat(kNotANumber));
  decisions.lobe = lobeOf(branches, material);
  return true;
}

#endif
