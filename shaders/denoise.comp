// Entry point of the denoiser: filters one pixel per invocation. docs/denoising.md, section 3.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/denoise_data.h"

layout(local_size_x = kDenoiseWorkgroupSide, local_size_y = kDenoiseWorkgroupSide, local_size_z = 1) in;
layout(push_constant) uniform Constants { DenoiseConstants constants; };
layout(set = 0, binding = 0, std430) readonly buffer Pixels { DenoisePixel pixels[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Results { vec4 results[]; };

// A neighbour has full weight up to the first of these values of the statistic, and none from the second on.
const float kFullMembership = 0.3;
const float kNoMembership = 1.5;
const float kPixelTolerance = 4.0;
const float kNormalWidth = 0.3;
const float kReflectanceWidth = 0.5;
const float kGuideNoise = 2.0;
const float kSmallestVariance = 1e-10;

uint indexOf(ivec2 pixel) { return uint(pixel.y) * constants.width + uint(pixel.x); }

bool isFiltered(ivec2 pixel) {
  if (any(lessThan(pixel, ivec2(0)))) return false;
  if (any(greaterThanEqual(pixel, ivec2(constants.width, constants.rows)))) return false;
  return pixels[indexOf(pixel)].light.w > 0.0;
}

// Returns the weight of a guide, which is the mean of a vector with its variance.
float guide(vec4 a, vec4 b, float width) {
  vec3 difference = a.xyz - b.xyz;
  float excess = dot(difference, difference) - kGuideNoise * (a.w + b.w);
  return max(0.0, 1.0 - max(0.0, excess) / (width * width));
}

// Returns the squared difference of the means of two pixels, and its variance.
vec2 compared(ivec2 a, ivec2 b) {
  vec4 first = pixels[indexOf(a)].root;
  vec4 second = pixels[indexOf(b)].root;
  vec3 difference = first.xyz - second.xyz;
  return vec2(dot(difference, difference), first.w + second.w + kSmallestVariance);
}

// Returns the sums of compared() over two patches. Their centres are pixels that are filtered.
vec2 comparedPatches(ivec2 a, ivec2 b) {
  vec2 sum = vec2(0.0);
  for (int y = -kDenoisePatchRadius; y <= kDenoisePatchRadius; ++y) {
    for (int x = -kDenoisePatchRadius; x <= kDenoisePatchRadius; ++x) {
      ivec2 offset = ivec2(x, y);
      if (isFiltered(a + offset) && isFiltered(b + offset)) sum += compared(a + offset, b + offset);
    }
  }
  return sum;
}

float membership(ivec2 a, ivec2 b) {
  vec2 ofPatches = comparedPatches(a, b);
  vec2 ofPixels = compared(a, b);
  float statistic = max(ofPatches.x / ofPatches.y, ofPixels.x / ofPixels.y / kPixelTolerance);
  return clamp((kNoMembership - statistic) / (kNoMembership - kFullMembership), 0.0, 1.0);
}

float closeness(ivec2 a, ivec2 b) {
  const float end = float(kDenoiseRadius + 1);
  vec2 offset = vec2(a - b);
  return max(0.0, 1.0 - dot(offset, offset) / (end * end));
}

float weightOf(ivec2 a, ivec2 b) {
  DenoisePixel own = pixels[indexOf(a)];
  DenoisePixel other = pixels[indexOf(b)];
  float guides = guide(own.normal, other.normal, kNormalWidth) *
                 guide(own.reflectance, other.reflectance, kReflectanceWidth);
  return guides > 0.0 ? guides * closeness(a, b) * membership(a, b) * other.light.w : 0.0;
}

vec3 filteredLight(ivec2 pixel) {
  vec3 own = pixels[indexOf(pixel)].light.xyz;
  if (!isFiltered(pixel)) return own;
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int y = -kDenoiseRadius; y <= kDenoiseRadius; ++y) {
    for (int x = -kDenoiseRadius; x <= kDenoiseRadius; ++x) {
      ivec2 neighbour = pixel + ivec2(x, y);
      if (!isFiltered(neighbour)) continue;
      float weight = weightOf(pixel, neighbour);
      sum += weight * (pixels[indexOf(neighbour)].light.xyz - own);
      weights += weight;
    }
  }
  return own + sum / weights;
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, constants.firstRow);
  if (pixel.x >= int(constants.width) || pixel.y >= int(constants.endRow)) return;
  results[indexOf(pixel - ivec2(0, constants.firstResultRow))] = vec4(filteredLight(pixel), 0.0);
}
