// Reflection by conductors: docs/light-transport.md section 5.10.
#ifndef CANDELA_CONDUCTOR_GLSL
#define CANDELA_CONDUCTOR_GLSL

// Returns the reflectance of one channel for unpolarised light. x is the cosine of the angle of incidence.
float conductorChannel(float x, float eta, float kappa) {
  float x2 = x * x;
  float s = 1.0 - x2;
  float product = 2.0 * eta * kappa;
  float t = eta * eta - kappa * kappa - s;
  float size = sqrt(t * t + product * product);
  float squared = mix(0.5 * (size + t), 0.5 * product * product / (size - t), t < 0.0);
  float twice = 2.0 * x * sqrt(squared);
  float across = (size + x2 - twice) / (size + x2 + twice);
  float along = across * (size * x2 + s * s - twice * s) / (size * x2 + s * s + twice * s);
  return 0.5 * (across + along);
}

// Returns the reflectance of each channel. One after the other needs fewer registers than vectors.
vec3 conductorReflectance(float x, vec3 eta, vec3 kappa) {
  float red = conductorChannel(x, eta.x, kappa.x);
  float green = conductorChannel(x, eta.y, kappa.y);
  return vec3(red, green, conductorChannel(x, eta.z, kappa.z));
}

#endif
