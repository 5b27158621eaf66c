// The list of the kinds of lights that have entries in the light table of a device.
#ifndef CANDELA_LISTS_LIGHT_KINDS_H
#define CANDELA_LISTS_LIGHT_KINDS_H

// X(flatten::LightKind, member of flatten::SceneFeatures, constant in GLSL, value in both). Kinds that rays may hit
// come first, and the environment last. The members are entries of CANDELA_FEATURES in features.h.
#define CANDELA_LIGHT_KINDS(X)                                        \
  X(sphere, sphereLights, kLightSphere, 0u)                           \
  X(triangle, triangleLights, kLightTriangle, 1u)                     \
  X(point, pointLights, kLightPoint, 2u)                              \
  X(punctual, punctualLights, kLightPunctual, 3u) /* with fall-off */ \
  X(spot, punctualLights, kLightSpot, 4u)                             \
  X(directional, punctualLights, kLightDirectional, 5u)               \
  X(environment, environmentLight, kLightEnvironment, 6u) /* no emission, no position */

#endif
