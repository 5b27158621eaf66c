// The list of the kinds of primitives.
#ifndef CANDELA_LISTS_PRIMITIVE_KINDS_H
#define CANDELA_LISTS_PRIMITIVE_KINDS_H

// X(scene::PrimitiveKind, member of flatten::SceneFeatures, constant in GLSL, value in both, flag in GLSL). The values
// are at most kKindMask - 1; the member and the flag are an entry of CANDELA_FEATURES in features.h.
#define CANDELA_PRIMITIVE_KINDS(X)                         \
  X(sphere, spheres, kKindSphere, 0u, kHasSpheres)         \
  X(triangle, triangles, kKindTriangle, 1u, kHasTriangles) \
  X(box, boxes, kKindBox, 2u, kHasBoxes)                   \
  X(cone, cones, kKindCone, 3u, kHasCones)                 \
  X(plane, planes, kKindPlane, 4u, kHasPlanes)

#endif
