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
  int period = wrap == kWrapMirroredRepeat ? 2 * count : count;
  if (wrap != kWrapClampToEdge) {
    x = x < 0 ? x + period : x;
    x = x >= period ? x - period : x;
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
  return constants.firstTextureRow + kSrgbTableRows + material * kMaterialTextureRows;
}

// Returns the first record of a material's reference, counted from the beginning of the textures, or 0 for none.
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
};

Lookup lookupAt(uint reference, vec4 texCoords) {
  uvec4 first = sceneRow(constants.firstTextureRow + reference);
  uvec4 second = sceneRow(constants.firstTextureRow + reference + 1u);
  vec2 uv = (first.w & kTextureSecondSet) != 0u ? texCoords.zw : texCoords.xy;
  precise float s = uintBitsToFloat(first.x) * uv.x + uintBitsToFloat(first.y) * uv.y + uintBitsToFloat(first.z);
  precise float t = uintBitsToFloat(second.x) * uv.x + uintBitsToFloat(second.y) * uv.y + uintBitsToFloat(second.z);
  uvec2 wrap = (uvec2(first.w) >> uvec2(kTextureWrapShiftS, kTextureWrapShiftT)) & kTextureWrapMask;
  return Lookup(vec2(s, t), uvec2(second.w & 0xffffu, second.w >> 16), wrap,
                constants.firstTextureRow + (first.w >> kTextureRowShift), (first.w & kTextureNearest) != 0u);
}

// Returns the texel, four packed bytes, that is displaced by fractions of a texel.
uint texelAt(Lookup at, vec2 displacement) {
  uint x = texelIndex(at.st.x, at.size.x, at.wrap.x, displacement.x);
  uint y = texelIndex(at.st.y, at.size.y, at.wrap.y, displacement.y);
  uint texel = y * at.size.x + x;
  return sceneRow(at.firstRow + (texel >> 2))[texel & 3u];
}

// Returns the texel that a reference selects with one pair of numbers.
uint textureTexel(uint reference, vec4 texCoords, vec2 jitter) {
  Lookup at = lookupAt(reference, texCoords);
  return texelAt(at, at.nearest ? vec2(0.0) : jitter - 0.5);
}

float redOf(uint texel) { return float(texel & 255u) * (1.0 / 255.0); }
float greenOf(uint texel) { return float((texel >> 8) & 255u) * (1.0 / 255.0); }
float blueOf(uint texel) { return float((texel >> 16) & 255u) * (1.0 / 255.0); }
float alphaOf(uint texel) { return float(texel >> 24) * (1.0 / 255.0); }

// Returns the alpha of a reference, interpolated among four texels unless its filter is `nearest`.
float filteredAlpha(uint reference, vec4 texCoords) {
  Lookup at = lookupAt(reference, texCoords);
  if (at.nearest) return alphaOf(texelAt(at, vec2(0.0)));
  vec2 position = vec2(at.size) * vec2(reducedCoordinate(at.st.x, at.wrap.x), reducedCoordinate(at.st.y, at.wrap.y));
  vec2 weight = fract(position - 0.5);
  float upper = mix(alphaOf(texelAt(at, vec2(-0.5))), alphaOf(texelAt(at, vec2(0.5, -0.5))), weight.x);
  float lower = mix(alphaOf(texelAt(at, vec2(-0.5, 0.5))), alphaOf(texelAt(at, vec2(0.5))), weight.x);
  return mix(upper, lower, weight.y);
}

float linearFromSrgb(uint value) { return sceneRowFloat(constants.firstTextureRow + (value >> 2))[value & 3u]; }

// Returns the linear colour of a texel whose colour is encoded in sRGB.
vec3 linearColour(uint texel) {
  return vec3(linearFromSrgb(texel & 255u), linearFromSrgb((texel >> 8) & 255u), linearFromSrgb((texel >> 16) & 255u));
}

#endif
