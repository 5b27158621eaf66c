// The lists of the quantities of a material that textures may give, and of the treatments of texture coordinates.
#ifndef CANDELA_LISTS_TEXTURES_H
#define CANDELA_LISTS_TEXTURES_H

// X(scene::TextureSlot, constant in GLSL, value in both: the index of the slot's word in a material's records). Unless
// stated otherwise, a texel is a factor of the quantity.
#define CANDELA_TEXTURE_SLOTS(X)                                                                                      \
  X(baseColour, kSlotBaseColour, 0u)               /* sRGB */                                                         \
  X(emission, kSlotEmission, 1u)                   /* sRGB */                                                         \
  X(metallicRoughness, kSlotMetallicRoughness, 2u) /* metalness: blue, roughness: green */                            \
  X(specular, kSlotSpecular, 3u)                   /* weight: alpha */                                                \
  X(specularColour, kSlotSpecularColour, 4u)       /* sRGB */                                                         \
  X(normal, kSlotNormal, 5u)               /* no factor: a direction in the tangent frame, in red, green and blue */  \
  X(transmission, kSlotTransmission, 6u)   /* weight: red */                                                          \
  X(coat, kSlotCoat, 7u)                   /* weight: red */                                                          \
  X(coatRoughness, kSlotCoatRoughness, 8u) /* green */                                                                \
  X(coatNormal, kSlotCoatNormal, 9u)       /* as `normal` */                                                          \
  X(sheenColour, kSlotSheenColour, 10u)    /* sRGB */                                                                 \
  X(sheenRoughness, kSlotSheenRoughness, 11u) /* alpha */                                                             \
  X(anisotropy, kSlotAnisotropy, 12u)         /* strength: blue; its direction in the tangent frame: red and green */ \
  X(film, kSlotFilm, 13u)                     /* weight: red */                                                       \
  X(filmThickness, kSlotFilmThickness, 14u)   /* green */                                                             \
  X(glossiness, kSlotGlossiness, 15u)         /* alpha, a factor of 1 - roughness */

// X(scene::TextureWrap, constant in GLSL, value in both).
#define CANDELA_TEXTURE_WRAPS(X)             \
  X(repeat, kWrapRepeat, 0u)                 \
  X(mirroredRepeat, kWrapMirroredRepeat, 1u) \
  X(clampToEdge, kWrapClampToEdge, 2u)

#endif
