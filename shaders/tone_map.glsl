// Display transforms: the curves of host/image/tone_map.cpp in single precision. The result is within 1/255 of theirs.
#ifndef CANDELA_TONE_MAP_GLSL
#define CANDELA_TONE_MAP_GLSL
#include "shared/window_data.h"

vec3 srgbEncode(vec3 linear) {
  vec3 curve = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

vec3 acesCurve(vec3 x) { return (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14); }

vec3 acesHillCurve(vec3 linear) {
  const mat3 toAces = mat3(0.59719, 0.07600, 0.02840,  //
                           0.35458, 0.90834, 0.13383,  //
                           0.04823, 0.01566, 0.83777);
  const mat3 toDisplay = mat3(1.60475, -0.10208, -0.00327,  //
                              -0.53108, 1.10813, -0.07276,  //
                              -0.07367, -0.00605, 1.07602);
  vec3 x = toAces * (linear / 0.6);
  return toDisplay * ((x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081));
}

vec3 agxContrast(vec3 x) {
  return -0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5)))));
}

vec3 agxCurve(vec3 linear) {
  const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051,  //
                          0.0784335999999992, 0.878468636469772, 0.0784336,           //
                          0.0792237451477643, 0.0791661274605434, 0.879142973793104);
  const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438,  //
                           -0.0980208811401368, 1.15190312990417, -0.0980434501171241,  //
                           -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
  const float minimumStop = -12.47393;
  const float maximumStop = 4.026069;
  vec3 stops = clamp(log2(max(inset * linear, vec3(1e-30))), minimumStop, maximumStop);
  vec3 signal = outset * agxContrast((stops - minimumStop) / (maximumStop - minimumStop));
  return pow(max(signal, vec3(0.0)), vec3(2.2));
}

vec3 neutralCurve(vec3 linear) {
  const float f90 = 0.04;
  const float s = 0.8 - f90;
  const float d = 0.15;
  float x = min(min(linear.x, linear.y), linear.z);
  float f = x <= 2.0 * f90 ? x - x * x / (4.0 * f90) : f90;
  vec3 shifted = linear - f;
  float p = max(max(shifted.x, shifted.y), shifted.z);
  if (p <= s) return shifted;
  float pn = 1.0 - (1.0 - s) * (1.0 - s) / (p + 1.0 - 2.0 * s);
  float g = 1.0 / (d * (p - pn) + 1.0);
  return shifted * (pn / p * g) + pn * (1.0 - g);
}

// The colour map of host/image/colour_map.h.
vec3 magma(float value) {
  float x = clamp(value, 0.0, 1.0);
  const vec3 c0 = vec3(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933);
  const vec3 c1 = vec3(0.2516605407371642, 0.6775232436837668, 2.494026599312351);
  const vec3 c2 = vec3(8.353717279216625, -3.577719514958484, 0.3144679030132573);
  const vec3 c3 = vec3(-27.66873308576866, 14.26473078096533, -13.64921318813922);
  const vec3 c4 = vec3(52.17613981234068, -27.94360607168351, 12.94416944238394);
  const vec3 c5 = vec3(-50.76852536473588, 29.04658282127291, 4.23415299384598);
  const vec3 c6 = vec3(18.65570506591883, -11.48977351997711, -5.601961508734096);
  return clamp(c0 + x * (c1 + x * (c2 + x * (c3 + x * (c4 + x * (c5 + x * c6))))), 0.0, 1.0);
}

// Returns the display signal, in [0, 1], of a linear colour that exposure has been applied to.
vec3 displaySignal(vec3 exposed, uint toneMap, float falseColourScale) {
  vec3 linear = mix(clamp(exposed, 0.0, 1e6), vec3(0.0), isnan(exposed));
  if (toneMap == kToneDepth) {
    float value = linear.x / falseColourScale;
    return vec3(value > 0.0 ? 1.0 / (1.0 + value * value) : 0.0);
  }
  if (toneMap == kToneHeat) return magma(linear.x / falseColourScale);
  if (toneMap == kToneAces) linear = acesCurve(linear);
  if (toneMap == kToneAcesHill) linear = acesHillCurve(linear);
  if (toneMap == kToneAgx) linear = agxCurve(linear);
  if (toneMap == kToneNeutral) linear = neutralCurve(linear);
  vec3 shown = clamp(linear, 0.0, 1.0);
  return toneMap == kToneNone ? shown : srgbEncode(shown);
}

#endif
