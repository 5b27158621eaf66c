// The list of the feature flags of a scene. Every file of this folder is a list of names that GLSL and C++ share, as a
// macro that applies its argument to every entry; both languages generate their declarations from it. A macro needs no
// generator in the build or in an installed header, and messages of both compilers point to these files.
#ifndef CANDELA_LISTS_FEATURES_H
#define CANDELA_LISTS_FEATURES_H

// X(member of flatten::SceneFeatures, name in GLSL, id of the specialisation constant). Features that a scene does not
// use are compiled out. Other ids are in shaders/shared/specialization.h; id 112 is free.
#define CANDELA_FEATURES(X)                                                                                 \
  X(spheres, kHasSpheres, 2) /* kinds of primitives present */                                              \
  X(triangles, kHasTriangles, 3)                                                                            \
  X(boxes, kHasBoxes, 4)                                                                                    \
  X(cones, kHasCones, 5)                                                                                    \
  X(planes, kHasPlanes, 6)                                                                                  \
  X(instances, kHasInstances, 96) /* some triangles are traversed in the space of their mesh */             \
  X(smooth, kHasSmooth, 7)        /* some triangle has vertex normals */                                    \
  X(diffuse, kHasDiffuse, 8)      /* lobes present */                                                       \
  X(glossy, kHasGlossy, 9)                                                                                  \
  X(mirror, kHasMirror, 10)                                                                                 \
  X(dielectric, kHasDielectric, 11)                                                                         \
  X(emission, kHasEmission, 12)         /* some primitive emits */                                          \
  X(sphereLights, kHasSphereLights, 13) /* kinds of entries in the light table */                           \
  X(triangleLights, kHasTriangleLights, 14)                                                                 \
  X(pointLights, kHasPointLights, 15)                                                                       \
  X(punctualLights, kHasPunctualLights, 29)  /* point with fall-off, spot, directional */                   \
  X(lightTree, kHasLightTree, 105)           /* lights are chosen by a tree */                              \
  X(lightInstances, kHasLightInstances, 106) /* some of them are instances */                               \
  X(touched, kHasTouched, 95)                /* some primitive may contain a light */                       \
  X(insideOnly, kHasInsideOnly, 26)          /* some sphere has a negative radius */                        \
  X(sky, kHasSky, 16)                                                                                       \
  X(environment, kHasEnvironment, 33)                                                                       \
  X(environmentLight, kHasEnvironmentLight, 34) /* it is in the light table */                              \
  X(mixtures, kHasMixtures, 25)                 /* some material has more than one lobe */                  \
  X(textures, kHasTextures, 35)                                                                             \
  X(textureTransforms, kHasTextureTransforms, 102) /* some texture is placed */                             \
  X(deepTexels, kHasDeepTexels, 87)                /* some image has channels of 16 bits */                 \
  X(transparency, kHasTransparency, 36)            /* some triangle may be passed */                        \
  X(secondTexCoords, kHasSecondTexCoords, 100)     /* some texture uses set 1 */                            \
  X(longCorners, kHasLongCorners, 101)             /* corners of triangles have three words */              \
  X(colours, kHasColours, 37)                      /* some triangle has vertex colours */                   \
  X(surfaces, kHasSurfaces, 30)                    /* some material has surface parameters */               \
  X(transmission, kHasTransmission, 31)            /* some surface transmits light */                       \
  X(volumes, kHasVolumes, 32)                      /* some transmitting surface bounds a volume */          \
  X(coats, kHasCoat, 80)                           /* some surface has a coat */                            \
  X(tangents, kHasTangents, 39)                    /* some triangle has tangents that its material needs */ \
  X(normalMaps, kHasNormalMaps, 81)                /* some of them for a normal map */                      \
  X(orthographic, kHasOrthographic, 38)            /* the camera's rays are parallel */                     \
  X(sheens, kHasSheen, 82)                         /* some surface has a sheen */                           \
  X(films, kHasFilm, 85)                           /* some surface has a thin film */                       \
  X(conductors, kHasConductors, 84)                /* some metal has a complex index */                     \
  X(anisotropy, kHasAnisotropy, 83)                /* some surface is rougher in one direction */           \
  X(dispersion, kHasDispersion, 86)                /* some volume has an index for each channel */          \
  X(plastics, kHasPlastic, 107)                    /* some surface is plastic */                            \
  X(interfaces, kHasInterfaces, 109)               /* some surface is a single interface */                 \
  X(choices, kHasChoices, 110)                     /* some material is a choice between two */              \
  X(filteredNormals, kHasFilteredNormals, 111)     /* some normal map has heights, or no facets */

#endif
