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
uint texelAt(vec2 point) {
  vec2 size = constants.environmentSize;
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
  float across = 0.5 + turnsOf(horizontal);
  float down = 2.0 * turnsOf(vec2(dot(direction, constants.environmentY), sine));
  vec2 place = vec2(constants.environmentSize.x * across, constants.environmentPole + constants.environmentRows * down);
  return loadTap(texelAt(place + jitter - 0.5), sine);
}

// Returns the number of records that a list of `count` ends and the spans of its numbers take.
uint recordsOfEnds(uint count) {
  uint records = (count + kEndsPerRow - 1u) / kEndsPerRow;
  return records + (records + kSpansPerRow - 1u) / kSpansPerRow;
}

// Returns the first of `count` intervals whose end is above a number, or the last one. Their ends begin at `row`. The
// span of the number says in which records the end may be, mostly in one.
uint chooseInterval(uint row, uint count, uint number, inout uint truncated) {
  uint records = (count + kEndsPerRow - 1u) / kEndsPerRow;
  uint part, lower;
  umulExtended(number, records, part, lower);
  uvec4 spans = sceneRow(row + records + part / kSpansPerRow);
  uvec2 span = part % kSpansPerRow == 0u ? spans.xy : spans.zw;
  uint record = firstThresholdAbove(number, row, 1u, kEndsPerRow - 1u, span.x, span.y, truncated);
  uvec3 passed = uvec3(greaterThanEqual(uvec3(number), sceneRow(row + record).xyz));
  return min(kEndsPerRow * record + passed.x + passed.y + passed.z, count - 1u);
}

// Chooses a row of texels by one word, and a texel in it by another one.
uint chooseTexel(uvec2 words, inout uint truncated) {
  uint width = constants.environmentWidth;
  uint height = constants.environmentHeight;
  uint ends = constants.firstEnvironmentRow + width * height;
  uint y = chooseInterval(ends, height, words.x, truncated);
  ends += recordsOfEnds(height) + y * recordsOfEnds(width);
  return y * width + chooseInterval(ends, width, words.y, truncated);
}

// `point` is uniform in the unit square.
LightSample sampleEnvironment(uvec2 words, vec2 point, inout uint truncated) {
  uint texel = chooseTexel(words, truncated);
  float s = float(texel % constants.environmentWidth) + 0.5 + sampleTent(point.x);
  float t = float(texel / constants.environmentWidth) + 0.5 + sampleTent(point.y);
  vec2 azimuth = -cosSinOfTurns(s / constants.environmentSize.x);
  // Its sine is negative beyond the poles, where the azimuth is the opposite one, unless the tent is folded there.
  vec2 polar = cosSinOfTurns(0.5 * (t - constants.environmentPole) / constants.environmentRows);
  if (constants.environmentPole > 0.0) polar.y = abs(polar.y);
  vec3 wi = polar.y * (azimuth.x * constants.environmentX + azimuth.y * constants.environmentZ) +
            polar.x * constants.environmentY;
  float sine = abs(polar.y);
  if (sine == 0.0) return kNoLight;
  EnvironmentTap tap = loadTap(texel, sine);
  return LightSample(wi, tap.radiance, kNoHit, tap.pdf, false, kNoPoint);
}

#endif
