// Draws the pictures of the device and of the reference into the pixels of a window.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "tone_map.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, set = 0, binding = 0) readonly buffer DevicePicture { vec4 devicePicture[]; };
layout(std430, set = 0, binding = 1) readonly buffer ReferencePicture { vec4 referencePicture[]; };
layout(std430, set = 0, binding = 2) writeonly buffer WindowPixels { uint windowPixels[]; };
layout(std430, set = 0, binding = 3) writeonly buffer Pointed { PointedValues pointed; };

layout(constant_id = kSpecWindowMode) const uint kMode = kShowDevice;
layout(constant_id = kSpecWindowToneMap) const uint kToneMap = kToneSrgb;
layout(push_constant) uniform Push { WindowConstants window; };

const vec3 kSurroundings = vec3(0.11, 0.12, 0.13);  // sRGB signals of what is beside the picture
const vec3 kDividerColour = vec3(1.0);
const float kPictureBelowDifference = 0.15;  // brightness of the picture below the difference

float luminanceOf(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }

vec3 shown(vec4 value) {
  vec3 scaled = (value.xyz - window.valueOffset.xyz) * window.valueGain.xyz;
  if (window.repeats != 0u) scaled = fract(scaled);
  if (window.hidesZero != 0u && value.xyz == vec3(0.0)) scaled = vec3(0.0);
  return value.w == 0.0 ? kSurroundings : displaySignal(scaled, kToneMap, window.falseColourScale);
}

float maxMagnitude(vec3 value) { return max(max(abs(value.x), abs(value.y)), abs(value.z)); }

// The difference of the two luminances, divided by their mean.
float lightDifference(vec3 device, vec3 reference) {
  float a = luminanceOf(device);
  float b = luminanceOf(reference);
  return a == b ? 0.0 : 2.0 * (a - b) / (a + b);
}

// The difference of the channel that differs most, divided by the mean of the maximum magnitudes.
float valueDifference(vec3 device, vec3 reference) {
  vec3 difference = device - reference;
  float most = abs(difference.x) >= abs(difference.y) ? difference.x : difference.y;
  most = abs(most) >= abs(difference.z) ? most : difference.z;
  return most == 0.0 ? 0.0 : 2.0 * most / (maxMagnitude(device) + maxMagnitude(reference));
}

// Blue where the reference is brighter, orange where the device is, hatched where the two cannot be compared.
vec3 differenceSignal(vec4 device, vec4 reference, uvec2 pixel) {
  if (device.w != reference.w || device.w == 0.0) return vec3(((pixel.x + pixel.y) / 4u & 1u) == 0u ? 0.16 : 0.22);
  float relative = window.isLight != 0u ? lightDifference(device.xyz, reference.xyz)
                                        : valueDifference(device.xyz, reference.xyz);
  float strength = min(abs(relative) * window.differenceGain, 1.0);
  vec3 colour = relative > 0.0 ? vec3(1.0, 0.55, 0.1) : vec3(0.15, 0.5, 1.0);
  return mix(vec3(kPictureBelowDifference * luminanceOf(shown(reference))), colour, strength);
}

vec3 pictureSignal(uvec2 pixel, vec2 position) {
  uint index = pixel.y * window.pictureSize.x + pixel.x;
  vec4 device = devicePicture[index];
  vec4 reference = referencePicture[index];
  if (kMode == kShowDevice) return shown(device);
  if (kMode == kShowReference) return shown(reference);
  if (kMode == kShowDifference) return differenceSignal(device, reference, pixel);
  if (abs(position.x - window.divider) * window.zoom < 1.0) return kDividerColour;
  return shown(position.x < window.divider ? device : reference);
}

uint packed(vec3 signal) {
  uvec3 bytes = uvec3(round(255.0 * signal));
  if (window.isBlueFirst != 0u) bytes = bytes.zyx;
  return bytes.x | bytes.y << 8 | bytes.z << 16 | 0xff000000u;
}

void main() {
  uvec2 at = gl_GlobalInvocationID.xy;
  if (at == uvec2(0u) && window.pointer.x != kNoPixel) {
    uint index = window.pointer.y * window.pictureSize.x + window.pointer.x;
    pointed.device = devicePicture[index];
    pointed.reference = referencePicture[index];
  }
  if (at.x >= window.windowSize.x || at.y >= window.windowSize.y) return;
  vec2 position = (vec2(at) + 0.5 - window.origin) / window.zoom;
  bool isInside = all(greaterThanEqual(position, vec2(0.0))) && all(lessThan(position, vec2(window.pictureSize)));
  vec3 signal = isInside ? pictureSignal(uvec2(position), position) : kSurroundings;
  windowPixels[at.y * window.windowSize.x + at.x] = packed(signal);
}
