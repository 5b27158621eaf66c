// Elementary functions that use only + - * /, so that they are equally accurate on every device (the errors of Vulkan's
// built-in functions may be 2^-11 or more). Relative errors are a few units in the last place.
#ifndef CANDELA_MATH_GLSL
#define CANDELA_MATH_GLSL
#include "options.glsl"

const float kPi = 3.14159265358979;
const float kLargestFloat = 3.402823e38;
const uint kNotANumber = 0x7fc00000u;

// Inspects the bits, because comparisons with NaN are not relied on.
bool isFinite(float value) { return (floatBitsToUint(value) & 0x7f800000u) != 0x7f800000u; }

// Maximum and minimum of two numbers, neither of which is NaN: docs/driver-workarounds.md section 8.
float larger(float a, float b) { return kMasksLanes ? a > b ? a : b : max(a, b); }
float smaller(float a, float b) { return kMasksLanes ? a < b ? a : b : min(a, b); }

// (cos x, sin x) for |x| <= pi/4: Taylor series, truncated below 2^-26.
vec2 cosSin(float x) {
  float x2 = x * x;
  float c = 1.0 + x2 * (-0.5 + x2 * (1.0 / 24.0 + x2 * (-1.0 / 720.0 + x2 * (1.0 / 40320.0 - x2 / 3628800.0))));
  float s = x * (1.0 + x2 * (-1.0 / 6.0 + x2 * (1.0 / 120.0 + x2 * (-1.0 / 5040.0 + x2 / 362880.0))));
  return vec2(c, s);
}

// (cos, sin) of `turns` times 2 pi, for |turns| < 2^20. It has no selection of two blocks: docs/driver-workarounds.md section 15.
vec2 cosSinOfTurns(float turns) {
  float quarters = floor(4.0 * turns + 0.5);
  vec2 cs = cosSin((2.0 * kPi) * (turns - 0.25 * quarters));
  uint quadrant = uint(int(quarters)) & 3u;
  if ((quadrant & 1u) != 0u) cs = vec2(-cs.y, cs.x);
  if ((quadrant & 2u) != 0u) cs = -cs;
  return cs;
}

// Returns the angle of a vector (cosine, sine) of any length in turns, in [-1/2, 1/2]; 0 for the zero vector. The arc tangent of
// [0, 1] is reduced to |a| <= tan(pi/8), where the polynomial, which interpolates atan(a)/a at Chebyshev nodes in a^2, has
// a relative error of 2e-8.
float turnsOf(vec2 v) {
  vec2 size = abs(v);
  float low = min(size.x, size.y);
  float high = max(size.x, size.y);
  if (high == 0.0) return 0.0;
  bool wide = low > 0.41421356 * high;
  float a = wide ? (low - high) / (low + high) : low / high;
  float a2 = a * a;
  float series = a * (0.99999998 + a2 * (-0.33332784 + a2 * (0.19974013 + a2 * (-0.13847735 + a2 * 0.079737912))));
  float turns = (0.5 / kPi) * series + (wide ? 0.125 : 0.0);
  turns = size.y > size.x ? 0.25 - turns : turns;
  turns = v.x < 0.0 ? 0.5 - turns : turns;
  return v.y < 0.0 ? -turns : turns;
}

// Splits x > 0 into m and e, x = m 2^e, with m in [1/sqrt 2, sqrt 2). Returns m.
float mantissaOf(float x, out int exponent) {
  uint bits = floatBitsToUint(x);
  exponent = int((bits + 0x004afb0du) >> 23) - 127;
  return uintBitsToFloat(bits - uint(exponent << 23));
}

// Returns log(m 2^exponent). log m = 2 atanh(less / (m+1)) with less = m - 1, whose series needs five terms.
float logOfParts(float m, float less, int exponent) {
  float f = less / (m + 1.0);
  float f2 = f * f;
  float series = 1.0 + f2 * (1.0 / 3.0 + f2 * (1.0 / 5.0 + f2 * (1.0 / 7.0 + f2 * (1.0 / 9.0))));
  return 2.0 * f * series + float(exponent) * 0.693147180559945;
}

// Returns log x for x > 0 that is not denormal.
float logarithm(float x) {
  int exponent;
  float m = mantissaOf(x, exponent);
  return logOfParts(m, m - 1.0, exponent);
}

// Returns log(1 - q) for q in [0, 1) without cancellation at small q.
float logOneMinus(float q) {
  int exponent;
  float m = mantissaOf(1.0 - q, exponent);
  return logOfParts(m, exponent == 0 ? -q : m - 1.0, exponent);
}

// Returns x and z such that exp(y) = x (1 + z), for y <= 80: y = k log 2 + r with |r| <= log(2)/2, and a Taylor series
// for r. log 2 is split into two parts.
vec2 exponentialParts(float y) {
  float bounded = max(y, -80.0);
  float k = floor(bounded * 1.44269504 + 0.5);
  float r = (bounded - k * 0.693359375) + k * 2.12194440e-4;
  float series = r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r / 5040.0))))));
  return vec2(uintBitsToFloat(uint(int(k) + 127) << 23), series);
}

// Returns exp(y) for y <= 80; results below exp(-80) become exp(-80).
float exponential(float y) {
  vec2 parts = exponentialParts(y);
  return parts.x + parts.x * parts.y;
}

// Returns exp(y) - 1 for y <= 0.
float expMinusOne(float y) {
  vec2 parts = exponentialParts(y);
  return parts.x * parts.y + (parts.x - 1.0);
}

// Normalises v. The built-in normalize() may use an approximate square root.
vec3 unit(vec3 v) { return v * (1.0 / sqrt(dot(v, v))); }

float largest(vec3 v) { return larger(larger(v.x, v.y), v.z); }
float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }

#endif
