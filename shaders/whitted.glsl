// The Whitted ray tracer, one ray of the tree at a time: docs/light-transport.md section 9. Between rays, all state is
// in a Tree, so that a tree can stop after any ray and continue in another dispatch with the same result.
#ifndef CANDELA_WHITTED_GLSL
#define CANDELA_WHITTED_GLSL
#include "background.glsl"
#include "camera.glsl"
#include "fresnel.glsl"
#include "material.glsl"
#include "normals.glsl"
#include "traversal.glsl"

struct Tree {
  Ray ray;         // the current ray
  float weight;    // of the ray's radiance in the sample
  uint node;       // 1: the camera ray; n reflects 2n and refracts 2n + 1. 0: the sample has not started
  uint pending;    // bit d: the refracted ray of depth d, a sibling of an ancestor of `node`, is pending
  uint nextLight;  // of this node; the lights before it are done
  vec3 radiance;
};

// The rays that a node spawns, and their factors. 0: there is no such ray.
struct Branches {
  vec3 reflected;
  float reflectedFactor;
  vec3 refracted;
  float refractedFactor;
};

const Branches kNoBranches = Branches(vec3(0.0), 0.0, vec3(0.0), 0.0);

// Decisions of a node, for comparison with another tracer.
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
  tree.pending = 0u;
  tree.nextLight = 0u;
  tree.radiance = vec3(0.0);
}

// Returns the point of a light that a node samples. `words` are its dimensions light u and light v.
vec3 lightPoint(PointLight light, uint number, uvec2 words) {
  if (!kHasAreaLights) return light.position;
  uvec2 turned = words + number * 0x9e3779b9u;
  return light.position + ((toUnit(turned.x) - 0.5) * light.edgeU + (toUnit(turned.y) - 0.5) * light.edgeV);
}

// Returns (N.H)^Shine, computed from the sine, which keeps its relative accuracy at the highlight's peak.
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

// Returns the contribution of one light at a surface.
vec3 lightShown(PointLight light, vec3 point, Surface surface, Normals normals, Material material, vec3 wo, inout Work work,
                inout uint shadow) {
  vec3 toLight = point - surface.position;
  float distance = sqrt(dot(toLight, toLight));
  precise vec3 wi = toLight / distance;
  bool faces = distance > 0.0 && dot(normals.shading, wi) > 0.0 && dot(normals.geometric, wi) > 0.0;
  shadow = kShadowNotTraced;
  if (!faces) return vec3(0.0);
  Ray ray = shadowRayFrom(surface, wi, false, true, point, distance);
  bool occluded = traceAny(ray, RayEnd(distance, kNoSlot, point), work);
  shadow = occluded ? kShadowOccluded : kShadowVisible;
  return occluded ? vec3(0.0) : light.colour * localColour(material, normals, wo, wi);
}

// Returns the contribution of the next lights at a node, at most kLightsPerSegment of them.
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
    if (kMasksLanes && tree.nextLight >= end) break;
  }
  work.truncated += cutShort;
  return sum;
}

// Returns the rays of a smooth boundary. wo + n wt is along the normal, where wt is the refracted direction and n the
// relative index of refraction; therefore wt is along (c - g) N - wo.
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

// Returns the rays that a node spawns. Rays on the wrong side of the geometric normal are dropped.
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

// Traces the current ray and shades its hit. Returns true if the node is done and its branches can be followed;
// otherwise some of its lights are left.
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
  surface = surfaceAt(tree.ray, hit);
  Material material = materialAt(surface);
  vec3 wo = -tree.ray.direction;
  Normals normals = normalsTowards(surface, wo);
  if (kHasEmission && first) tree.radiance += tree.weight * material.emission;
  if (kHasPointLights && material.diffuseWeight + material.glossyWeight > 0.0) {
    tree.radiance += tree.weight * directLight(tree, key, surface, normals, material, work, counts, decisions);
    if (tree.nextLight < constants.lightCount) return false;
  }
  if (depthOf(tree.node) < constants.maxDepth) branches = branchesAt(normals, material, wo);
  // A value that is not finite must not be lost silently: the film counts it as a bad sample.
  bool sound = isSound(branches.reflected, branches.reflectedFactor) && isSound(branches.refracted, branches.refractedFactor);
  if (!sound) tree.radiance = vec3(uintBitsToFloat(kNotANumber));
  decisions.lobe = lobeOf(branches, material);
  return true;
}

#endif
