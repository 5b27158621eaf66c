// The list of the lobes of materials. The shaders read it as well, but it is in this folder because the reference
// tracer includes nothing of the shaders.
#ifndef CANDELA_RENDER_LOBE_LIST_H
#define CANDELA_RENDER_LOBE_LIST_H

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
