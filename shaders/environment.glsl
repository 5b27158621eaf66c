// The environment: the choice of a texel of its map as the radiance in a direction, and light samples of
// it (docs/light-transport.md section 6).
#ifndef CANDELA_ENVIRONMENT_GLSL
#define CANDELA_ENVIRONMENT_GLSL
#include "lights.glsl"
#include "math.glsl"
#include "sampling.glsl"
#include "scene_access.glsl"

struct EnvironmentTap {
  vec3 radiance;
  float pdf;  // with which light sampling chooses the direction and this tap, with the choice of the light
};

// Reads a texel. `sine` is that of the direction's angle from the map's y axis.
EnvironmentTap loadTap(uint texel, float sine) {
  vec4 row = sceneRowFloat(constants.firstEnvironmentRow + texel);
  return EnvironmentTap(row.xyz, constants.environmentProbability * row.w / sine);
}

// Returns the texel at a point of the map, which may be beyond its edges by less than its size.
uint texelAt(vec2 point, vec2 size) {
  bool beyond = point.y < 0.0 || point.y > size.y;
  float x = point.x + (beyond ? 0.5 * size.x : 0.0);
  float y = point.y < 0.0 ? -point.y : (beyond ? 2.0 * size.y - point.y : point.y);
  x -= size.x * floor(x / size.x);
  uvec2 texel = min(uvec2(x, y), uvec2(constants.environmentWidth, constants.environmentHeight) - 1u);
  return texel.y * constants.environmentWidth + texel.x;
}

// `jitter` is uniform in the unit square.
EnvironmentTap environmentTap(vec3 direction, vec2 jitter) {
  vec2 horizontal = vec2(dot(direction, constants.environmentX), dot(direction, constants.environmentZ));
  float sine = sqrt(dot(horizontal, horizontal));
  vec2 size = vec2(constants.environmentWidth, constants.environmentHeight);
  float across = 0.5 + turnsOf(horizontal);
  float down = 2.0 * turnsOf(vec2(dot(direction, constants.environmentY), sine));
  return loadTap(texelAt(size * vec2(across, down) + jitter - 0.5, size), sine);
}

// Chooses a texel by the alias table. The number is words.x 2^32 + words.y; the bin and the 24 bits that decide between the
// texel of this index and its alias are the upper bits of its product with the number of bins.
uint chooseTexel(uvec2 words) {
  uint bins = constants.environmentWidth * constants.environmentHeight;
  uint bin, middle, carried, lowest;
  umulExtended(words.x, bins, bin, middle);
  umulExtended(words.y, bins, carried, lowest);
  uint fraction = middle + carried;
  bin += fraction < carried ? 1u : 0u;
  uvec4 pair = sceneRow(constants.firstEnvironmentRow + bins + bin / kBinsPerRow);
  uvec2 entry = bin % kBinsPerRow == 0u ? pair.xy : pair.zw;
  return fraction >> 8 < entry.x ? bin : entry.y;
}

// `point` is uniform in the unit square.
LightSample sampleEnvironment(uvec2 words, vec2 point) {
  uint texel = chooseTexel(words);
  float s = float(texel % constants.environmentWidth) + 0.5 + sampleTent(point.x);
  float t = float(texel / constants.environmentWidth) + 0.5 + sampleTent(point.y);
  vec2 azimuth = -cosSinOfTurns(s / float(constants.environmentWidth));
  vec2 polar = cosSinOfTurns(0.5 * t / float(constants.environmentHeight));  // its sine is negative beyond the poles
  vec3 wi = polar.y * (azimuth.x * constants.environmentX + azimuth.y * constants.environmentZ) +
            polar.x * constants.environmentY;
  float sine = abs(polar.y);
  if (sine == 0.0) return kNoLight;
  EnvironmentTap tap = loadTap(texel, sine);
  return LightSample(wi, tap.radiance, kNoHit, tap.pdf, false, kNoPoint);
}

#endif
