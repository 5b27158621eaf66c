// The path tracer, one segment at a time: docs/light-transport.md section 7. Between segments, all state is in a Path,
// so that a path can stop after any segment and continue in another dispatch with the same result.
#ifndef CANDELA_PATH_GLSL
#define CANDELA_PATH_GLSL
#include "background.glsl"
#include "bsdf.glsl"
#include "camera.glsl"
#include "environment.glsl"
#include "layers.glsl"
#include "lights.glsl"
#include "material_choice.glsl"
#include "shading.glsl"
#include "trace.glsl"
#include "traversal.glsl"
#include "volumes.glsl"

struct Path {
  Ray ray;
  float pdf;        // of the ray's direction; 0: delta
  vec3 throughput;
  vec3 radiance;
  uint depth;       // of the ray, 1 for the camera ray; 0: the sample has not started
  uint volume;      // number of the volume that the ray is in; 0: none
  uint receiver;    // word of receiverAt() for the origin of the ray, if the scene has a light tree
};

// Decisions of a segment, for comparison with another tracer.
struct Decisions {
  uint index;
  uint lobe;
  uint shadow;
  bool survived;
};

struct RayCounts {
  uint bounce;
  uint shadow;
  uint vertices;
};

void startPath(inout Path path, SampleKey key, uvec2 pixel) {
  vec3 origin, direction;
  cameraRay(pixel, toUnit(sampleGroup(key, 0u)), origin, direction);
  path.ray = makeRay(origin, direction, kNoSlot);
  path.pdf = 0.0;
  path.throughput = vec3(1.0);
  path.radiance = vec3(0.0);
  path.depth = 1u;
  path.volume = 0u;
  path.receiver = 0u;
}

// Returns the emission of a surface that BSDF sampling hit, weighted against light sampling (multiple importance
// sampling).
vec3 emissionFound(Path path, Surface surface, vec3 emission, float t, inout Work work) {
  bool fromBehind = dot(surface.outward, path.ray.direction) >= 0.0;
  if (kOneSided && isKind(surface.kind, kKindTriangle) && fromBehind) return vec3(0.0);
  float weight = 1.0;
  if (kHasSampledEmitters && path.pdf > 0.0 && surface.light != 0u) {
    Light light = emitterFound(surface, path.ray.origin, path.receiver, work.truncated);
    weight = powerHeuristic(path.pdf, lightPdf(light, path.ray, surface, t));
  }
  noteEmission(emission, weight);
  return emission * weight;
}

// Returns the background's radiance, weighted against light sampling; for camera rays that of the backdrop.
vec3 backgroundFound(Path path, SampleKey key) {
  if (kBackdrop != kBackdropEnvironment && path.depth == 1u) {
    return kBackdrop == kBackdropColour ? constants.background : vec3(0.0);
  }
  if (!kHasEnvironment) return backgroundRadiance(path.ray.direction);
  EnvironmentTap tap = environmentTap(path.ray.direction, toUnit(sampleGroup(key, environmentGroup(path.depth)).xy));
  bool weighted = kHasEnvironmentLight && path.pdf > 0.0 && tap.pdf > 0.0;
  return tap.radiance * (weighted ? powerHeuristic(path.pdf, tap.pdf) : 1.0);
}

// Returns a contribution of light that was scattered `scatterings` times before it reached the camera, or with a limit for
// indirect light at most the limit, in the same hue.
vec3 limitedContribution(vec3 contribution, uint scatterings) {
  if (!kLimitsIndirect || scatterings < 2u) return contribution;
  float highest = largest(contribution);
  return highest > constants.indirectLimit ? contribution * (constants.indirectLimit / highest) : contribution;
}

// A ray to a light sample, and its contribution to the path if it is unoccluded.
struct ShadowRay {
  bool wanted;    // false: there is no shadow ray, and the other members are undefined
  Ray ray;
  RayEnd end;
  vec3 radiance;  // the contribution, multiplied by the throughput
};

// Samples a light of any kind. `numbers` are those of the light choice and the three that follow.
LightSample sampleAnyLight(Light light, Surface surface, uvec4 numbers, SampleKey key, uint depth, inout Work work) {
  if (kHasEnvironmentLight && light.kind == kLightEnvironment) {
    return sampleEnvironment(numbers.yz, toUnit(sampleGroup(key, environmentGroup(depth)).zw), work.truncated);
  }
  return sampleLight(light, surface, toUnit(numbers).yz);
}

// Returns the word that makes a LightReceiver of a vertex.
uint receiverWord(Shading shading, Material material) {
  vec3 normal = shading.frame[2];
  if (kHasNormalMaps && shading.facets.exist) normal = shading.outside ? shading.outward : -shading.outward;
  return packDirection(normal) | (scattersTo(material, true) ? kReceiverTransmits : 0u);
}

// Stage of the specification, if some lobe is smooth: samples one entry of the light table, and prepares the ray that
// finds whether it is visible. `numbers` are those of the light choice and the three that follow.
void light(inout ShadowRay shadow, Path path, SampleKey key, Surface surface, Shading shading, Material material,
           uvec4 numbers, inout Work work) {
  uint entry;
  Light light = chooseLight(surface.position, path.receiver, numbers.x >> 8, key, path.depth, entry, work.truncated);
  noteLightChoice(entry, light);
  LightSample lit = sampleAnyLight(light, surface, numbers, key, path.depth, work);
  float pdf;
  vec3 wi = lit.wi * shading.frame;
  bool transmitted = wi.z < 0.0;
  vec3 scattered;
  if (kHasNormalMaps) {
    transmitted = shading.facets.exist ? facingCosine(shading, lit.wi) <= 0.0 : transmitted;
    scattered = facetScattering(material, shading.facets, shading.wo, wi, transmitted, pdf);
    if (kHasFilteredNormals) scattered *= bumpShadowing(shading.unmapped, wi);
  } else {
    scattered = evaluateBsdf(material, shading.wo, wi, pdf) * abs(wi.z);
  }
  bool received = scattersTo(material, transmitted) && keepsSide(shading, lit.wi, transmitted);
  vec3 arriving = scattered * lit.emission;
  if (lit.pdf <= 0.0 || !received || largest(arriving) <= 0.0) return;
  float weight = lit.delta ? 1.0 : powerHeuristic(lit.pdf, pdf);
  vec3 weighed = arriving * (weight / lit.pdf);
  if (kHasVolumes && lit.distance < kLargestFloat) {
    weighed *= volumeTransmittance(transmitted ? volumeBeyond(material, shading.outside, path.volume) : path.volume,
                                   lit.distance);
  }
  precise vec3 radiance = limitedContribution(path.throughput * weighed, path.depth);
  float distance = lit.distance;
  bool isFixed = (kHasPointLights || kHasPunctualLights) && lit.delta && light.kind != kLightDirectional;
  Ray ray = shadowRayFrom(surface, lit.wi, transmitted, isFixed, lit.point, distance);
  shadow = ShadowRay(true, ray, RayEnd(distance, light.slot, lit.point), radiance);
  if (kHasTransparency) shadow.ray.opacityKey = opacityKey(key, path.depth, true);
  noteShadowRay(lit, pdf, weight, weighed);
}

// Stage of the specification: samples the next direction. Returns true if the path continues.
bool scatter(inout Path path, Surface surface, Shading shading, Material material, float lobeNumber, vec2 numbers,
             inout Decisions decisions) {
  BsdfSample next = sampleBsdf(material, shading.wo, shading.outside, vec3(lobeNumber, numbers));
  decisions.lobe = next.lobe;
  if (next.lobe == kLobeNone) return false;
  if (kHasNormalMaps && shading.facets.exist) next = leavingFacet(material, shading.facets, shading.wo, next);
  if (kHasFilteredNormals) next.weight *= bumpShadowing(shading.unmapped, next.wi);
  precise vec3 direction = unit(shading.frame * next.wi);
  bool kept = keepsSide(shading, direction, next.lobe == kLobeRefract);
  path.throughput *= next.weight;
  path.pdf = next.pdf;
  path.ray = rayFrom(surface, direction, next.lobe == kLobeRefract);
  noteScattering(next, direction);
  // A value that is not finite must not end a path silently: the film counts it as a bad sample.
  if (!isFinite(dot(path.throughput, direction))) {
    path.radiance = vec3(uintBitsToFloat(kNotANumber));
    return false;
  }
  bool continues = kept && largest(path.throughput) > 0.0;
  if (kHasVolumes && continues && next.lobe == kLobeRefract) {
    countVolumeFault(material, shading.outside, path.volume);
    path.volume = volumeBeyond(material, shading.outside, path.volume);
  }
  return continues;
}

// Stage of the specification: plays Russian roulette. Returns true if the path survives. For the same number of rays, the
// square root of the throughput gives less noise than the throughput itself (docs/performance-journal.md, "Russian
// roulette").
bool roulette(inout Path path, float number) {
  if (path.depth <= constants.rouletteStart) return true;
  float survival = min(1.0, sqrt(largest(path.throughput)));
  noteRoulette(survival);
  path.throughput /= survival;
  return number < survival;
}

// Stage of the specification, without the tracing of the ray. Returns true if the ray has hit a surface; if it has not,
// the path ends in the background.
bool arrive(inout Path path, Hit hit, SampleKey key, inout RayCounts counts) {
  counts.bounce += path.depth > 1u ? 1u : 0u;
  if (hit.t >= kNoHit) {
    if (kHasVolumes && path.volume != 0u) volumeFaults += 1u;
    path.radiance += limitedContribution(path.throughput * backgroundFound(path, key), path.depth - 1u);
    return false;
  }
  counts.vertices += 1u;
  if (kHasVolumes) path.throughput *= volumeTransmittance(path.volume, hit.t);
  return true;
}

// Stage of the specification: adds the emission of the surface.
void emit(inout Path path, Surface surface, vec3 emission, float t, inout Work work) {
  vec3 found = path.throughput * emissionFound(path, surface, emission, t, work);
  path.radiance += limitedContribution(found, path.depth - 1u);
}

// Notes what layers and mattes show of the hit, in renders that have any.
void noteLayers(Path path, Surface surface, Material material, float t) {
  if (path.depth == 1u || kThroughSpecular) noteFirstHit(path.ray, surface, material, t, path.depth, path.radiance);
  if (kSumsScatteredOnce && path.depth == 2u) noteScatteredOnce(path.radiance);
}

// Computes everything from the hit of the path's ray to the next ray, except for tracing the shadow ray. Returns true
// if the path continues.
bool shadeHit(inout Path path, Hit hit, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions,
              out ShadowRay shadow) {
  decisions = Decisions(kRecordMiss, kLobeNone, kShadowNotTraced, true);
  shadow.wanted = false;
  if (!arrive(path, hit, key, counts)) return false;
  decisions.index = hit.index;
  Surface surface = surfaceAt(path.ray, hit);
  if (kHasTextures) surface.jitter = textureJitter(key, path.depth);
  if (kHasChoices) chooseMaterial(surface, path.ray.direction, materialNumber(key, path.depth));
  Material material = materialAt(surface);
  if (kHasEmission && kHasCoat && material.isSurface) {
    float cosine = abs(dot(surface.outward, path.ray.direction));
    material.emission *= 1.0 - coatReflectance(material.surface.coatWeight, cosine);
  }
  if (kHasAnisotropy) alignAnisotropy(surface, material);
  if (kHasNormalMaps) mapLayer(surface, material, -path.ray.direction, key, path.depth);
  noteSurface(path.ray, surface, hit.t);
  if (kHasEmission) emit(path, surface, material.emission, hit.t, work);
  if (kLayerSums != 0u || kListsHits && kThroughSpecular) noteLayers(path, surface, material, hit.t);
  if (path.depth >= constants.maxDepth) return false;

  Shading shading = shadingAt(surface, -path.ray.direction);
  if (kHasDispersion && material.isSurface && material.surface.transmissionDispersionScale > 0.0) {
    chooseChannel(material, path.throughput, channelNumber(key, path.depth));
  }
  prepareLobes(material, shading.wo, shading.outside);
  if (kHasLightTree) path.receiver = receiverWord(shading, material);
  uvec4 choices = uvec4(0u);
  if (kHasLights || kHasMixtures) choices = sampleGroup(key, vertexGroup(path.depth, kDimensionLightChoice));
  if (kHasLights && hasSmoothLobe(material)) light(shadow, path, key, surface, shading, material, choices, work);
  counts.shadow += shadow.wanted ? 1u : 0u;
  vec4 numbers = toUnit(sampleGroup(key, vertexGroup(path.depth, kDimensionBsdfU)));
  if (!scatter(path, surface, shading, material, toUnit(choices.w), numbers.xy, decisions)) return false;
  decisions.survived = roulette(path, numbers.z);
  path.depth += 1u;
  return decisions.survived;
}

// Traces the shadow ray and adds its contribution if it is unoccluded. Returns kShadowVisible or kShadowOccluded.
uint traceShadow(ShadowRay shadow, inout vec3 radiance, inout Work work) {
  bool blocked = traceAny(shadow.ray, shadow.end, work);
  if (!blocked) radiance += shadow.radiance;
  uint outcome = blocked ? kShadowOccluded : kShadowVisible;
  noteShadow(outcome);
  return outcome;
}

// Traces the path's ray and computes everything up to the next ray. Returns true if the path continues.
bool extendPath(inout Path path, SampleKey key, inout Work work, inout RayCounts counts, out Decisions decisions) {
  if (kHasTransparency) path.ray.opacityKey = opacityKey(key, path.depth, false);
  Hit hit = traceClosest(path.ray, work);
  ShadowRay shadow;
  bool continues = shadeHit(path, hit, key, work, counts, decisions, shadow);
  if (kHasLights && shadow.wanted) decisions.shadow = traceShadow(shadow, path.radiance, work);
  return continues;
}

#endif
