// Rays that are traced alone, for benchmarks, and their hits.
#ifndef CANDELA_SHARED_CAST_RAY_H
#define CANDELA_SHARED_CAST_RAY_H
#include "language.h"
CANDELA_BEGIN

// A ray. Its origin is off the surface, so that there is no origin primitive.
struct CastRay {
  vec4 originLimit;  // xyz; w: maximum distance, 0: there is no such ray
  vec4 direction;    // xyz, unit; w of a primary ray: loops truncated while the rays of its pixel were generated
};

struct CastHit {
  // Bits of the distance, primitive index or kNoPrimitive (a shadow ray: 0, and 1 if occluded), steps, truncated loops.
  uvec4 found;
};
CANDELA_CONST uint kNoPrimitive = 0xffffffffu;

// Each pixel has three rays, in this order.
CANDELA_CONST uint kPrimaryRay = 0u;
CANDELA_CONST uint kDiffuseRay = 1u;  // cosine-weighted random direction from the hit of the primary ray
CANDELA_CONST uint kShadowRay = 2u;   // from there to a random point of the lights
CANDELA_CONST uint kRayKindCount = 3u;

// Number of workgroups in a unit. A dispatch consists of whole units.
CANDELA_CONST uint kCastUnit = 8u;

// Push constants, one per dispatch.
struct CastConstants {
  uint first;  // index of a ray or of a pixel
  uint end;
  uint invocations;  // per workgroup
  uint unitStride;   // see cast_rays.comp
};

CANDELA_END
#endif
