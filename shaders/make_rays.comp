// Entry point of the kernel that generates the rays of a benchmark, three per pixel, with the functions of the path
// tracer. It has one invocation per pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "camera.glsl"
#include "lights.glsl"
#include "normals.glsl"
#include "shared/cast_ray.h"
#include "traversal.glsl"

layout(local_size_x_id = kSpecWorkgroupX, local_size_y_id = kSpecWorkgroupY, local_size_z = 1) in;
layout(push_constant) uniform Dispatch { CastConstants range; };
layout(set = 0, binding = kBindingPathStates, std430) writeonly buffer Rays { CastRay rays[]; };

const CastRay kNoRay = CastRay(vec4(0.0), vec4(0.0, 0.0, 1.0, 0.0));

// Returns an origin off the surface by a few rounding errors of its coordinates, even where the path tracer needs no
// offset.
vec3 originBeside(Surface surface, Normals normals) {
  return surface.position + normals.geometric * (largest(abs(surface.position)) * (1.0 / 262144.0));
}

CastRay diffuseRay(Surface surface, Normals normals, SampleKey key) {
  vec2 numbers = toUnit(sampleGroup(key, vertexGroup(1u, kDimensionBsdfU))).xy;
  vec3 direction = unit(frameAround(normals.geometric) * sampleCosineHemisphere(numbers));
  return CastRay(vec4(originBeside(surface, normals), kNoHit), vec4(direction, 0.0));
}

CastRay shadowRay(Surface surface, Normals normals, SampleKey key, inout Work work) {
  uvec4 numbers = sampleGroup(key, vertexGroup(1u, kDimensionLightChoice));
  uint receiver = packDirection(normals.geometric);
  uint entry;
  Light light = chooseLight(surface.position, receiver, numbers.x >> 8, key, 1u, entry, work.truncated);
  LightSample lit = sampleLight(light, surface, toUnit(numbers).yz);
  if (lit.pdf <= 0.0 || dot(lit.wi, normals.geometric) <= 0.0) return kNoRay;
  return CastRay(vec4(originBeside(surface, normals), lit.distance * (1.0 - 1.0 / 1024.0)), vec4(lit.wi, 0.0));
}

void main() {
  uint i = range.first + gl_WorkGroupID.x * range.invocations + gl_LocalInvocationIndex;
  if (i >= range.end) return;
  uvec2 pixel = uvec2(i % constants.imageWidth, i / constants.imageWidth);
  SampleKey key = sampleKeyOf(pixel, 0u);
  vec3 origin, direction;
  cameraRay(pixel, toUnit(sampleGroup(key, 0u)), origin, direction);
  Ray ray = makeRay(origin, direction, kNoSlot);
  Work work = Work(0u, 0u);
  Hit hit = traceClosest(ray, work);
  CastRay diffuse = kNoRay;
  CastRay shadow = kNoRay;
  if (hit.t < kNoHit) {
    Surface surface = surfaceAt(ray, hit);
    Normals normals = normalsTowards(surface, -direction);
    diffuse = diffuseRay(surface, normals, key);
    if (kHasLights) shadow = shadowRay(surface, normals, key, work);
  }
  rays[i * kRayKindCount + kPrimaryRay] = CastRay(vec4(origin, kNoHit), vec4(direction, float(work.truncated)));
  rays[i * kRayKindCount + kDiffuseRay] = diffuse;
  rays[i * kRayKindCount + kShadowRay] = shadow;
}
