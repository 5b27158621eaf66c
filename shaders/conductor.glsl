// Reflection by conductors: docs/light-transport.md section 5.10.
#ifndef CANDELA_CONDUCTOR_GLSL
#define CANDELA_CONDUCTOR_GLSL

// Returns the reflectance for unpolarised light, for each channel. x is the cosine of the angle of incidence.
vec3 conductorReflectance(float x, vec3 eta, vec3 kappa) {
  float x2 = x * x;
  float s = 1.0 - x2;
  vec3 product = 2.0 * eta * kappa;
  vec3 t = eta * eta - kappa * kappa - s;
  vec3 size = sqrt(t * t + product * product);
  vec3 squared = mix(0.5 * (size + t), 0.5 * product * product / (size - t), lessThan(t, vec3(0.0)));
  vec3 twice = 2.0 * x * sqrt(squared);
  vec3 across = (size + x2 - twice) / (size + x2 + twice);
  vec3 along = across * (size * x2 + s * s - twice * s) / (size * x2 + s * s + twice * s);
  return 0.5 * (across + along);
}

#endif
