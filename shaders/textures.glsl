// Lookups of textures: docs/light-transport.md section 11.
#ifndef CANDELA_TEXTURES_GLSL
#define CANDELA_TEXTURES_GLSL
#include "sampler.glsl"
#include "scene_access.glsl"

// Returns the jitter of the textures at a path's vertex in x and y, and at the light that it samples in z and w.
vec4 textureJitter(SampleKey key, uint depth) { return toUnit(sampleGroup(key, vertexGroup(depth, kDimensionTextureU))); }

// Returns the numbers that choose a facet of a normal-mapped surface, a layer, and a facet of the coat.
vec4 facetNumbers(SampleKey key, uint depth) { return toUnit(sampleGroup(key, vertexGroup(depth, kDimensionFacet))); }

// Returns the number that chooses the channel of a surface with dispersion.
float channelNumber(SampleKey key, uint depth) { return facetNumbers(key, depth).w; }

// Reduces a texture coordinate to one period of its wrap mode, or to 0 to 1, so that indices of texels are small.
float reducedCoordinate(float s, uint wrap) {
  float bounded = abs(s) < 8388608.0 ? s : 0.0;
  if (wrap == kWrapRepeat) return bounded - floor(bounded);
  if (wrap == kWrapMirroredRepeat) return bounded - 2.0 * floor(0.5 * bounded);
  return clamp(bounded, 0.0, 1.0);
}

// Returns the texel of a row or column of `count` that index x stands for; x is at most one beyond a period.
uint wrappedTexel(int x, int count, uint wrap) {
  int period = count * (wrap == kWrapMirroredRepeat ? 2 : 1);
  if (wrap != kWrapClampToEdge) {
    if (x < 0) x += period;
    if (x >= period) x -= period;
    if (wrap == kWrapMirroredRepeat && x >= count) x = period - 1 - x;
  }
  return uint(clamp(x, 0, count - 1));
}

uint texelIndex(float s, uint count, uint wrap, float displacement) {
  precise float position = float(count) * reducedCoordinate(s, wrap) + displacement;
  return wrappedTexel(int(floor(position)), int(count), wrap);
}

// Returns the first of a material's records: see shared/scene_rows.h.
uint materialTextureRow(uint material) {
  uint tableRows = kHasDeepTexels ? kDeepSrgbTableRows : kSrgbTableRows;
  return constants.firstTextureRow + tableRows + material * kMaterialTextureRows;
}

// Returns the word that refers to a material's reference: its first record, counted from the beginning of the textures,
// with kDeepReference if the image has channels of 16 bits; or 0 for none.
uint textureOf(uint material, uint slot) {
  if ((kTextureSlots & (1u << slot)) == 0u) return 0u;
  return sceneRow(materialTextureRow(material) + (slot >> 2))[slot & 3u];
}

// A use of an image, at some texture coordinates.
struct Lookup {
  vec2 st;          // coordinates s and t
  uvec2 size;       // of the image
  uvec2 wrap;       // kWrap...
  uint firstRow;    // of the image
  bool nearest;
  bool deep;        // channels have 16 bits
};

Lookup lookupAt(uint reference, vec4 texCoords) {
  uint row = constants.firstTextureRow + (kHasDeepTexels ? reference & ~kDeepReference : reference);
  uvec4 first = sceneRow(row);
  uvec4 second = kHasTextureTransforms ? sceneRow(row + 1u) : uvec4(0u, floatBitsToUint(1.0), 0u, 0u);
  vec2 uv = texCoords.xy;
  if ((first.w & kTextureSecondSet) != 0u) uv = texCoords.zw;
  vec2 rowS = kHasTextureTransforms ? uintBitsToFloat(first.xy) : vec2(1.0, 0.0);
  precise float s = rowS.x * uv.x + rowS.y * uv.y + uintBitsToFloat(second.w);
  precise float t = uintBitsToFloat(second.x) * uv.x + uintBitsToFloat(second.y) * uv.y + uintBitsToFloat(second.z);
  uvec2 wrap = (uvec2(first.w) >> uvec2(kTextureWrapShiftS, kTextureWrapShiftT)) & kTextureWrapMask;
  return Lookup(vec2(s, t), uvec2(first.z & 0xffffu, first.z >> 16), wrap,
                constants.firstTextureRow + (first.w >> kTextureRowShift), (first.w & kTextureNearest) != 0u,
                kHasDeepTexels && (reference & kDeepReference) != 0u);
}

// Returns a texel of 8 bits per channel as one of 16 bits: 257 b / 65535 is b / 255.
uvec2 deepTexel(uint texel) {
  return (uvec2(texel, texel >> 16) & 255u | (uvec2(texel, texel >> 16) & 0xff00u) << 8) * 257u;
}

// Returns the texel that is displaced by fractions of a texel: four packed bytes in x, or in scenes with images of 16
// bits per channel, red and green in x, blue and alpha in y.
uvec2 texelAt(Lookup at, vec2 displacement) {
  uint x = texelIndex(at.st.x, at.size.x, at.wrap.x, displacement.x);
  uint y = texelIndex(at.st.y, at.size.y, at.wrap.y, displacement.y);
  uint texel = y * at.size.x + x;
  if (kHasDeepTexels && at.deep) {
    uvec4 pair = sceneRow(at.firstRow + (texel >> 1));
    if ((texel & 1u) != 0u) pair.xy = pair.zw;
    return pair.xy;
  }
  uint packed = sceneRow(at.firstRow + (texel >> 2))[texel & 3u];
  return kHasDeepTexels ? deepTexel(packed) : uvec2(packed, 0u);
}

// Returns the texel that a reference selects with one pair of numbers.
uvec2 textureTexel(uint reference, vec4 texCoords, vec2 jitter) {
  Lookup at = lookupAt(reference, texCoords);
  return texelAt(at, at.nearest ? vec2(0.0) : jitter - 0.5);
}

// Returns the stored integers of a texel's channels.
uvec4 channelsOf(uvec2 texel) {
  if (kHasDeepTexels) return uvec4(texel.x & 65535u, texel.x >> 16, texel.y & 65535u, texel.y >> 16);
  return uvec4(texel.x & 255u, (texel.x >> 8) & 255u, (texel.x >> 16) & 255u, texel.x >> 24);
}

// Returns the channels of a texel, from 0 to 1.
vec4 channelValues(uvec2 texel) { return vec4(channelsOf(texel)) * (kHasDeepTexels ? 1.0 / 65535.0 : 1.0 / 255.0); }

float redOf(uvec2 texel) { return channelValues(texel).x; }
float greenOf(uvec2 texel) { return channelValues(texel).y; }
float blueOf(uvec2 texel) { return channelValues(texel).z; }
float alphaOf(uvec2 texel) { return channelValues(texel).w; }

// Returns the weights of the next texels across and down among the four around the coordinates of a lookup.
vec2 nextTexelWeights(Lookup at) {
  vec2 position = vec2(at.size) * vec2(reducedCoordinate(at.st.x, at.wrap.x), reducedCoordinate(at.st.y, at.wrap.y));
  return fract(position - 0.5);
}

// Returns the channels of a reference, interpolated among four texels unless its filter is `nearest`.
vec4 filteredTexel(uint reference, vec4 texCoords) {
  Lookup at = lookupAt(reference, texCoords);
  if (at.nearest) return channelValues(texelAt(at, vec2(0.0)));
  vec2 weight = nextTexelWeights(at);
  vec4 upper = mix(channelValues(texelAt(at, vec2(-0.5))), channelValues(texelAt(at, vec2(0.5, -0.5))), weight.x);
  vec4 lower = mix(channelValues(texelAt(at, vec2(-0.5, 0.5))), channelValues(texelAt(at, vec2(0.5))), weight.x);
  return mix(upper, lower, weight.y);
}

float linearFromSrgb(uint value) { return sceneRowFloat(constants.firstTextureRow + (value >> 2))[value & 3u]; }

// Returns the linear colour of a texel whose colour is encoded in sRGB.
vec3 linearColour(uvec2 texel) {
  uvec4 channels = channelsOf(texel);
  return vec3(linearFromSrgb(channels.x), linearFromSrgb(channels.y), linearFromSrgb(channels.z));
}

#endif
