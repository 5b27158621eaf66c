// The list of the parameters of surfaces, and of the 16-byte records in which a device has them.
#ifndef CANDELA_LISTS_SURFACE_PARAMETERS_H
#define CANDELA_LISTS_SURFACE_PARAMETERS_H

// RECORD(name, constant in GLSL, its index among the records of a surface, whether a kernel loads it).
#define CANDELA_SURFACE_RECORDS(RECORD)                              \
  RECORD(base, kSurfaceBase, 0u, true)                               \
  RECORD(specular, kSurfaceSpecular, 1u, true)                       \
  RECORD(shape, kSurfaceShape, 2u, true)                             \
  RECORD(coat, kSurfaceCoat, 3u, kHasCoat || kHasVolumes)            \
  RECORD(direction, kSurfaceDirection, 4u, kHasAnisotropy)           \
  RECORD(sheen, kSurfaceSheen, 5u, kHasSheen)                        \
  RECORD(film, kSurfaceFilm, 6u, kHasFilm)                           \
  RECORD(eta, kSurfaceEta, 7u, kHasConductors)                       \
  RECORD(kappa, kSurfaceKappa, 8u, kHasConductors || kHasDispersion) \
  RECORD(plastic, kSurfacePlastic, 9u, kHasPlastic || kHasInterfaces)

// COLOUR(member, default, record): three floats, in x, y and z of the record. NUMBER(member, default, record, lane).
// FLAG(member, default): a device derives it. The members are those of scene::SurfaceParameters and of GLSL's struct of
// the same name. The other lanes of the records are in shaders/shared/scene_rows.h.
#define CANDELA_SURFACE_PARAMETERS(COLOUR, NUMBER, FLAG)                                                              \
  COLOUR(baseColour, 1, base)                                                                                         \
  NUMBER(metalness, 0, base, w)                                                                                       \
  COLOUR(specularColour, 1, specular)    /* factor of a dielectric's reflectance at normal incidence; may exceed 1 */ \
  NUMBER(specularWeight, 1, specular, w) /* of a dielectric's reflection at all angles */                             \
  NUMBER(roughness, 1, shape, x)         /* perceptual: alpha is its square */                                        \
  /* index of refraction of the inside relative to the outside, at least 1; or 0: reflects everything */              \
  NUMBER(ior, 1.5f, shape, y)                                                                                         \
  NUMBER(transmissionWeight, 0, shape, z) /* fraction of the diffuse reflection that transmission replaces */         \
  /* of a volume whose Abbe number is 20 divided by it; 0: no dispersion */                                           \
  NUMBER(transmissionDispersionScale, 0, kappa, w)                                                                    \
  FLAG(isThinWalled, true)    /* the surface bounds no volume, and light passes it without refraction */              \
  COLOUR(absorption, 0, coat) /* coefficient of the volume, per unit of length in the scene, >= 0 */                  \
  NUMBER(coatWeight, 0, coat, w)                                                                                      \
  COLOUR(sheenColour, 0, sheen) /* albedo of the fibres on the surface, relative to that of white ones */             \
  NUMBER(sheenRoughness, 0, sheen, w)                                                                                 \
  NUMBER(coatRoughness, 0, shape, w)                                                                                  \
  NUMBER(anisotropy, 0, direction, y)        /* alpha along its direction is mix(alpha, 1, anisotropy^2) */           \
  NUMBER(filmWeight, 0, film, x)             /* of interference in a thin film on the surface */                      \
  NUMBER(filmIor, 1.3f, film, y)             /* at least 1 */                                                         \
  NUMBER(filmThickness, 400, film, z)        /* in nanometres */                                                      \
  NUMBER(filmThicknessMinimum, 100, film, w) /* in nanometres, where a texture's thickness is 0 */

#endif
