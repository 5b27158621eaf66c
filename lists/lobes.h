// The list of the lobes of materials.
#ifndef CANDELA_LISTS_LOBES_H
#define CANDELA_LISTS_LOBES_H

// X(render::Lobe, constant in GLSL, value in both, which path records contain). `none`: the path ends before the
// choice.
#define CANDELA_LOBES(X)       \
  X(none, kLobeNone, 0u)       \
  X(diffuse, kLobeDiffuse, 1u) \
  X(glossy, kLobeGlossy, 2u)   \
  X(mirror, kLobeMirror, 3u)   \
  X(reflect, kLobeReflect, 4u) \
  X(refract, kLobeRefract, 5u) \
  X(coat, kLobeCoat, 6u)       \
  X(sheen, kLobeSheen, 7u)

#endif
