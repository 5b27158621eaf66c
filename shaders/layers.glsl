// Layers: sums of properties of the surfaces that camera rays hit, and of parts of the light, in records after the film
// of the band (docs/layers.md). The contributions of a sample are pending until it ends, so that layers have the
// samples of the film wherever a path stops. Without kLayerSums, layers generate no code.
#ifndef CANDELA_LAYERS_GLSL
#define CANDELA_LAYERS_GLSL

#ifdef CANDELA_HAS_FILM
#include "albedo.glsl"
#include "dispatch.glsl"
#include "normals.glsl"

layout(set = 0, binding = kBindingFilm, std430) buffer Layers { uvec4 layerRows[]; };

// The pending contributions of the current sample.
const uint kPendingHit = 1u;
const uint kPendingScatteredOnce = 2u;
const uint kPendingUnscattered = kThroughSpecular ? 4u : kPendingHit;
struct LayerSample {
  uint stored;  // kPending...: the members that have a value
  vec3 normal;
  vec3 albedo;
  vec3 depthTexCoord;
  vec3 position;
  vec3 unscattered;
  vec3 scatteredOnce;
};
LayerSample pending = LayerSample(0u, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));

// Sums of three channels over at most 2^10 samples: high + middle 2^-20 + low 2^-40. Each part of a sample is at most
// 2^20 in magnitude, so that integers of 32 bits hold the sums without carries.
struct PartialSums {
  ivec3 high;
  ivec3 middle;
  ivec3 low;
};
const PartialSums kNoSums = PartialSums(ivec3(0), ivec3(0), ivec3(0));
struct LayerSums {
  uint hits;
  uint outOfRange;
  PartialSums normal;
  PartialSums albedo;
  PartialSums depthTexCoord;
  PartialSums position;
  PartialSums unscattered;
  PartialSums scatteredOnce;
  PartialSums rootRadiance;
  PartialSums albedoSquared;
};
LayerSums gathered =
    LayerSums(0u, 0u, kNoSums, kNoSums, kNoSums, kNoSums, kNoSums, kNoSums, kNoSums, kNoSums);

uint layerHeader(uint pixelIndex) { return dispatch.bandPixels * kFilmRows + pixelIndex * kLayerRows; }

float pendingAt(uint row) { return uintBitsToFloat(layerRows[row].w); }
vec3 pendingVector(uint row) { return vec3(pendingAt(row), pendingAt(row + 1u), pendingAt(row + 2u)); }

// Reads what a path stored in its last dispatch: in w of the records of the channels, and in z of the header.
void loadPendingLayers(uint pixelIndex) {
  uint header = layerHeader(pixelIndex);
  pending.stored = layerRows[header].z;
  if (kSumsNormal) pending.normal = pendingVector(header + kNormalSumRow);
  if (kSumsAlbedo) pending.albedo = pendingVector(header + kAlbedoSumRow);
  if (kSumsDepth) pending.depthTexCoord.x = pendingAt(header + kDepthSumRow);
  if (kSumsPosition) pending.position = pendingVector(header + kPositionSumRow);
  if (kSumsTexCoord) {
    pending.depthTexCoord.yz = vec2(pendingAt(header + kTexCoordSumRow), pendingAt(header + kTexCoordSumRow + 1u));
  }
  if (kSumsUnscattered) pending.unscattered = pendingVector(header + kUnscatteredSumRow);
  if (kSumsScatteredOnce) pending.scatteredOnce = pendingVector(header + kScatteredOnceSumRow);
}

// True if layers see through the surface that the ray of this segment has hit.
bool seenThrough = false;

// Returns whether layers see through the surface: a perfect mirror, or smooth glass without another lobe.
bool isPerfect(Material m) {
  bool isGlass = kHasDielectric && m.dielectricWeight > 0.0 && m.diffuseWeight == 0.0 && m.glossyWeight == 0.0;
  if (kHasSurfaces && m.isSurface) return isSmoothInterface(m.surface);
  return kHasMirror && m.mirror || isGlass;
}

// Notes the length of a path whose hits before this one were seen through. Returns whether the layers show this hit.
bool showsHit(Material material, float t, uint depth) {
  if (depth == 1u) pending.depthTexCoord.x = 0.0;
  seenThrough = isPerfect(material);
  if ((pending.stored & kPendingHit) != 0u) return false;
  pending.depthTexCoord.x += t;
  return !seenThrough;
}

// Notes the values of a hit that layers show: that of the camera ray, or the first that layers do not see through.
// `radiance` is the path's radiance so far.
void noteFirstHit(Ray ray, Surface surface, Material material, float t, uint depth, vec3 radiance) {
  if (depth == 1u) pending.stored = kThroughSpecular ? kPendingUnscattered : kPendingHit;
  if (depth == 1u && kSumsUnscattered) pending.unscattered = radiance;
  if (kThroughSpecular) {
    if (!showsHit(material, t, depth)) return;
    pending.stored |= kPendingHit;
    t = pending.depthTexCoord.x;
  }
  if (kSumsNormal) pending.normal = normalsTowards(surface, -ray.direction).shading;
  if (kSumsAlbedo) pending.albedo = albedo(material);
  if (kSumsDepth || kSumsTexCoord) pending.depthTexCoord = vec3(t, surface.texCoords.xy);
  if (kSumsPosition) pending.position = surface.position;
}

// Notes the path's radiance before it is scattered for the second time.
void noteScatteredOnce(vec3 radiance) {
  pending.stored |= kPendingScatteredOnce;
  pending.scatteredOnce = radiance;
}

// Adds values truncated towards 0 to multiples of 2^-40. Each is at most kFilmMaximum in magnitude; every step is exact.
void addParts(inout PartialSums sums, vec3 value) {
  precise vec3 high = trunc(value);
  precise vec3 rest = (value - high) * 1048576.0;
  precise vec3 middle = trunc(rest);
  precise vec3 low = (rest - middle) * 1048576.0;
  sums.high += ivec3(high);
  sums.middle += ivec3(middle);
  sums.low += ivec3(low);
}

// Returns 0 for components that are not finite, and limits the others to kFilmMaximum in magnitude. Sets `bad` in both cases.
vec3 layerValue(vec3 value, inout bool bad) {
  uvec3 size = floatBitsToUint(value) & 0x7fffffffu;
  bool fits = all(lessThanEqual(size, uvec3(floatBitsToUint(kFilmMaximum))));
  bad = bad || !fits;
  if (fits) return value;
  return mix(vec3(0.0), clamp(value, -kFilmMaximum, kFilmMaximum), lessThan(size, uvec3(0x7f800000u)));
}

float partOf(float kept, float part) { return inRange(part) ? min(part, kept) : 0.0; }

// Returns a part of the light in the film's unit, limited to the value that the film adds for the sample.
vec3 partOf(vec3 kept, vec3 radiance) {
  vec3 part = filmRadiance(radiance);
  return vec3(partOf(kept.x, part.x), partOf(kept.y, part.y), partOf(kept.z, part.z));
}

// Gathers the layers of a sample that the film has received.
void gatherLayers(vec3 radiance) {
  bool hit = (pending.stored & kPendingHit) != 0u;
  bool scattered = (pending.stored & kPendingScatteredOnce) != 0u;
  bool hasScattered = (pending.stored & kPendingUnscattered) != 0u;
  bool bad = false;
  if (kSumsNormal) addParts(gathered.normal, hit ? layerValue(pending.normal, bad) : vec3(0.0));
  if (kSumsAlbedo) addParts(gathered.albedo, hit ? layerValue(pending.albedo, bad) : vec3(0.0));
  if (kSumsDepth || kSumsTexCoord) {
    // Selected rather than multiplied by 0: a value without a layer may be infinite.
    vec3 value = vec3(kSumsDepth ? pending.depthTexCoord.x : 0.0, kSumsTexCoord ? pending.depthTexCoord.yz : vec2(0.0));
    addParts(gathered.depthTexCoord, hit ? layerValue(value, bad) : vec3(0.0));
  }
  if (kSumsPosition) addParts(gathered.position, hit ? layerValue(pending.position, bad) : vec3(0.0));
  vec3 kept = keptRadiance(filmRadiance(radiance));
  if (kSumsUnscattered) addParts(gathered.unscattered, partOf(kept, hasScattered ? pending.unscattered : radiance));
  if (kSumsScatteredOnce) addParts(gathered.scatteredOnce, partOf(kept, scattered ? pending.scatteredOnce : radiance));
  if (kSumsRootRadiance) addParts(gathered.rootRadiance, sqrt(kept));
  if (kSumsAlbedoSquared) {
    vec3 squared = vec3(dot(pending.albedo, pending.albedo), 0.0, 0.0);
    addParts(gathered.albedoSquared, hit ? layerValue(squared, bad) : vec3(0.0));
  }
  gathered.hits += hit ? 1u : 0u;
  gathered.outOfRange += hit && bad ? 1u : 0u;
  pending.stored = 0u;
}

// Adds gathered sums to the record of a channel, and stores the pending value.
void storeChannel(uint row, int high, int middle, int low, float value) {
  uvec3 sum = layerRows[row].xyz;
  sum = addFixed(sum, uvec3(uvec2(low, low >> 31), low >> 31));
  sum = addFixed(sum, uvec3(uvec2(middle << 20, middle >> 12), middle >> 31));
  sum = addFixed(sum, uvec3(0u, uvec2(high << 8, high >> 24)));
  layerRows[row] = uvec4(sum, pending.stored != 0u ? floatBitsToUint(value) : 0u);
}

void storeChannels(uint row, PartialSums sums, vec3 value) {
  for (uint i = 0u; i < 3u; ++i) storeChannel(row + i, sums.high[i], sums.middle[i], sums.low[i], value[i]);
}

// Adds the gathered sums to those of the pixel, and stores the pending values.
void storeLayers(uint pixelIndex) {
  uint header = layerHeader(pixelIndex);
  uvec4 counts = layerRows[header];
  layerRows[header] = uvec4(counts.x + gathered.hits, counts.y + gathered.outOfRange, pending.stored, 0u);
  if (kSumsNormal) storeChannels(header + kNormalSumRow, gathered.normal, pending.normal);
  if (kSumsAlbedo) storeChannels(header + kAlbedoSumRow, gathered.albedo, pending.albedo);
  PartialSums others = gathered.depthTexCoord;
  if (kSumsDepth) {
    storeChannel(header + kDepthSumRow, others.high.x, others.middle.x, others.low.x, pending.depthTexCoord.x);
  }
  if (kSumsPosition) storeChannels(header + kPositionSumRow, gathered.position, pending.position);
  if (kSumsTexCoord) {
    uint row = header + kTexCoordSumRow;
    storeChannel(row, others.high.y, others.middle.y, others.low.y, pending.depthTexCoord.y);
    storeChannel(row + 1u, others.high.z, others.middle.z, others.low.z, pending.depthTexCoord.z);
  }
  if (kSumsUnscattered) storeChannels(header + kUnscatteredSumRow, gathered.unscattered, pending.unscattered);
  if (kSumsScatteredOnce) storeChannels(header + kScatteredOnceSumRow, gathered.scatteredOnce, pending.scatteredOnce);
  if (kSumsRootRadiance) storeChannels(header + kRootRadianceSumRow, gathered.rootRadiance, vec3(0.0));
  if (kSumsAlbedoSquared) {
    PartialSums squared = gathered.albedoSquared;
    storeChannel(header + kAlbedoSquaredSumRow, squared.high.x, squared.middle.x, squared.low.x, 0.0);
  }
}

#else
#define noteFirstHit(ray, surface, material, t, depth, radiance)
#define noteScatteredOnce(radiance)
#endif

#endif
