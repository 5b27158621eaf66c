// The radiance that a ray sees when it hits nothing: a colour or a sky box (docs/light-transport.md section 7).
#ifndef CANDELA_BACKGROUND_GLSL
#define CANDELA_BACKGROUND_GLSL
#include "scene_access.glsl"

float linearFromByte(uint value) {
  uvec4 row = sceneRow(constants.firstSkyRow + kSkyFaceCount + (value >> 2));
  return uintBitsToFloat(row[value & 3u]);
}

vec3 skyTexel(uvec4 face, int x, int y) {
  uint column = uint(clamp(x, 0, int(face.x) - 1));
  uint line = uint(clamp(y, 0, int(face.y) - 1));
  uint texel = face.z + line * face.x + column;
  uint packed = sceneRow(constants.firstSkyRow + kSkyFaceCount + kSkyTableRows + (texel >> 2))[texel & 3u];
  return vec3(linearFromByte(packed & 255u), linearFromByte((packed >> 8) & 255u), linearFromByte(packed >> 16));
}

// Returns the face (right, left, top, bottom, front, back) that the direction's dominant axis selects, and the
// coordinates (sc, tc) on it. Ties go to x, then to y.
uint skyFace(vec3 d, out vec2 point) {
  vec3 size = abs(d);
  if (size.x >= size.y && size.x >= size.z) {
    point = vec2(d.x > 0.0 ? -d.z : d.z, d.y) / size.x;
    return d.x > 0.0 ? 0u : 1u;
  }
  if (size.y >= size.z) {
    point = vec2(-d.x, d.y > 0.0 ? -d.z : d.z) / size.y;
    return d.y > 0.0 ? 2u : 3u;
  }
  point = vec2(d.z > 0.0 ? -d.x : d.x, d.y) / size.z;
  return d.z > 0.0 ? 4u : 5u;
}

vec3 skyRadiance(vec3 direction) {
  vec2 point;
  uvec4 face = sceneRow(constants.firstSkyRow + skyFace(direction, point));
  vec2 texel = 0.5 * vec2(point.x + 1.0, 1.0 - point.y) * vec2(face.xy) - 0.5;
  vec2 corner = floor(texel);
  vec2 weight = texel - corner;
  int x = int(corner.x);
  int y = int(corner.y);
  vec3 upper = skyTexel(face, x, y) * (1.0 - weight.x) + skyTexel(face, x + 1, y) * weight.x;
  vec3 lower = skyTexel(face, x, y + 1) * (1.0 - weight.x) + skyTexel(face, x + 1, y + 1) * weight.x;
  return upper * (1.0 - weight.y) + lower * weight.y;
}

vec3 backgroundRadiance(vec3 direction) {
  if (kHasSky) return skyRadiance(direction);
  return constants.background;
}

#endif
