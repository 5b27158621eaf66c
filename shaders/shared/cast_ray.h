// Rays that are traced alone, for benchmarks, and what they hit.
#ifndef CANDELA_SHARED_CAST_RAY_H
#define CANDELA_SHARED_CAST_RAY_H
#include "language.h"
CANDELA_BEGIN

// Starts beside the surface that it leaves, so that no primitive needs to be left out.
struct CastRay {
  vec4 originLimit;  // xyz; w: how far it looks, 0: there is no such ray
  vec4 direction;    // xyz, unit; w of a primary ray: loops truncated while its pixel's rays were made
};

struct CastHit {
  // Distance as its bits, primitive index or kNoPrimitive (a shadow ray: 0, and 1 if blocked), steps, truncated.
  uvec4 found;
};
CANDELA_CONST uint kNoPrimitive = 0xffffffffu;

// For each pixel three rays, in this order.
CANDELA_CONST uint kPrimaryRay = 0u;
CANDELA_CONST uint kDiffuseRay = 1u;  // in a random direction, by the cosine, from where the primary ray hits
CANDELA_CONST uint kShadowRay = 2u;   // from there to a random point of the lights
CANDELA_CONST uint kRayKindCount = 3u;

// Workgroups that stay together: a dispatch has a multiple of them.
CANDELA_CONST uint kCastUnit = 8u;

// One per dispatch.
struct CastConstants {
  uint first;        // index of a ray or of a pixel
  uint end;
  uint invocations;  // of a workgroup
  uint unitStride;   // see cast_rays.comp
};

CANDELA_END
#endif
