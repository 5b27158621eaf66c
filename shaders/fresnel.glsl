// Reflection at a smooth boundary between two dielectrics: docs/light-transport.md section 9.
#ifndef CANDELA_FRESNEL_GLSL
#define CANDELA_FRESNEL_GLSL

// Exact reflectance for unpolarised light. c in (0, 1] is the cosine of the angle of incidence, and n > 0 is the index
// of refraction on the far side of the boundary, divided by that on the near side. With g = n times the cosine of refraction,
// rs = (c - g) / (c + g) and rp = rs (c (g + c) - 1) / (c (g - c) + 1) (Cook and Torrance 1982), where
// g - c = (n^2 - 1) / (g + c) does not cancel. With total reflection the result is 1, and g is 0.
float fresnelReflectance(float c, float n, out float g) {
  float excess = (n - 1.0) * (n + 1.0);
  precise float gSquared = excess + c * c;
  g = sqrt(max(gSquared, 0.0));
  if (gSquared <= 0.0) return 1.0;
  float sum = g + c;
  float difference = excess / sum;
  float rs = difference / sum;
  float ratio = (c * sum - 1.0) / (c * difference + 1.0);
  precise float reflectance = 0.5 * rs * rs * (1.0 + ratio * ratio);
  return reflectance;
}

#endif
