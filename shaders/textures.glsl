// Lookups of textures: docs/light-transport.md section 11.
#ifndef CANDELA_TEXTURES_GLSL
#define CANDELA_TEXTURES_GLSL
#include "primitives.glsl"
#include "sampler.glsl"
#include "scene_access.glsl"

// Returns the jitter of the textures at a path's vertex in x and y, and at the light that it samples in z and w.
vec4 textureJitter(SampleKey key, uint depth) { return toUnit(sampleGroup(key, vertexGroup(depth, kDimensionTextureU))); }

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
  precise float place = float(count) * reducedCoordinate(s, wrap) + displacement;
  return wrappedTexel(int(floor(place)), int(count), wrap);
}

// Returns the first record of a material's reference, counted from the beginning of the textures, or 0 for none.
uint textureOf(uint material, uint slot) {
  return sceneRow(constants.firstTextureRow + kSrgbTableRows + material * kTextureSlotRows + (slot >> 2))[slot & 3u];
}

// Returns the texel, four packed bytes, that a reference selects with one pair of numbers.
uint textureTexel(uint reference, vec4 texCoords, vec2 jitter) {
  uvec4 first = sceneRow(constants.firstTextureRow + reference);
  uvec4 second = sceneRow(constants.firstTextureRow + reference + 1u);
  vec2 uv = (first.w & kTextureSecondSet) != 0u ? texCoords.zw : texCoords.xy;
  precise float s = uintBitsToFloat(first.x) * uv.x + uintBitsToFloat(first.y) * uv.y + uintBitsToFloat(first.z);
  precise float t = uintBitsToFloat(second.x) * uv.x + uintBitsToFloat(second.y) * uv.y + uintBitsToFloat(second.z);
  vec2 displacement = (first.w & kTextureNearest) != 0u ? vec2(0.0) : jitter - 0.5;
  uint width = second.w & 0xffffu;
  uint x = texelIndex(s, width, (first.w >> kTextureWrapShiftS) & kTextureWrapMask, displacement.x);
  uint y = texelIndex(t, second.w >> 16, (first.w >> kTextureWrapShiftT) & kTextureWrapMask, displacement.y);
  uint texel = y * width + x;
  return sceneRow(constants.firstTextureRow + (first.w >> kTextureRowShift) + (texel >> 2))[texel & 3u];
}

float linearFromSrgb(uint value) { return sceneRowFloat(constants.firstTextureRow + (value >> 2))[value & 3u]; }

// Returns the linear colour of a texel whose colour is encoded in sRGB.
vec3 linearColour(uint texel) {
  return vec3(linearFromSrgb(texel & 255u), linearFromSrgb((texel >> 8) & 255u), linearFromSrgb((texel >> 16) & 255u));
}

#endif
