// The test of cones, which returns the distance of the closest valid hit, or kNoHit, and the frame that normals share.
#ifndef CANDELA_CONE_GLSL
#define CANDELA_CONE_GLSL
#include "ray.glsl"

// Frame that cone tests and normals share: z is the height above the base, rho the radius at that height.
struct ConeFrame {
  vec3 axis;
  float height;
  float slope;  // d rho / d z
};

ConeFrame coneFrame(vec3 base, float baseRadius, vec3 apex, float apexRadius) {
  ConeFrame frame;
  vec3 axis = apex - base;
  frame.height = sqrt(dot(axis, axis));
  frame.axis = axis / frame.height;
  frame.slope = (apexRadius - baseRadius) / frame.height;
  return frame;
}

float coneRootInRange(float t, float shift, float z, float dz, float height) {
  float at = z + t * dz;
  return at >= 0.0 && at <= height ? positiveOrNone(t + shift) : kNoHit;
}

// Returns the distance by which the origin is moved before the quadratic is set up, so that its coefficients do not
// cancel: to the point of the ray closest to the middle of the axis, and from there to the point closest to the axis
// itself, but no farther than a hit can be.
float coneShift(ConeFrame cone, vec3 fromBase, vec3 direction, vec3 dAcross, float reach) {
  float toMiddle = -dot(fromBase - 0.5 * cone.height * cone.axis, direction);
  vec3 middle = fromBase + toMiddle * direction;
  float squared = dot(dAcross, dAcross);
  float toAxis = squared > 0.0 ? -dot(middle, dAcross) / squared : 0.0;
  return toMiddle + clamp(toAxis, -reach, reach);
}

float hitCone(Ray ray, vec3 base, float baseRadius, vec3 apex, float apexRadius, bool startsHere) {
  ConeFrame cone = coneFrame(base, baseRadius, apex, apexRadius);
  vec3 fromBase = ray.origin - base;
  precise float dz = dot(ray.direction, cone.axis);
  precise vec3 dAcross = ray.direction - dz * cone.axis;
  float reach = cone.height + baseRadius + apexRadius;
  float shift = startsHere ? 0.0 : coneShift(cone, fromBase, ray.direction, dAcross, reach);
  precise vec3 m = fromBase + shift * ray.direction;
  precise float z = dot(m, cone.axis);
  precise vec3 across = m - z * cone.axis;
  float rho = baseRadius + cone.slope * z;
  float dRho = cone.slope * dz;
  precise float a = dot(dAcross, dAcross) - dRho * dRho;
  precise float b = dot(across, dAcross) - dRho * rho;
  if (startsHere) return a == 0.0 ? kNoHit : coneRootInRange(-2.0 * b / a, 0.0, z, dz, cone.height);
  precise float c = dot(across, across) - rho * rho;
  precise float discriminant = b * b - a * c;
  if (discriminant < 0.0) return kNoHit;
  float root = sqrt(discriminant);
  float q = b > 0.0 ? -b - root : root - b;
  float first = q == 0.0 ? kNoHit : coneRootInRange(c / q, shift, z, dz, cone.height);
  float second = a == 0.0 ? kNoHit : coneRootInRange(q / a, shift, z, dz, cone.height);
  return min(first, second);
}

#endif
