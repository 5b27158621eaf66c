// The albedo of a material as views and layers show it: docs/light-transport.md section 10.
#ifndef CANDELA_ALBEDO_GLSL
#define CANDELA_ALBEDO_GLSL
#include "material.glsl"

vec3 albedo(Material m) {
  if (kHasSurfaces && m.isSurface) return m.surface.baseColour;
  if (kHasMirror && m.mirror) return m.specular;
  // If the diffuse and the dielectric lobe have the same colour, the weights are added before they are multiplied.
  vec3 apart = kHasDielectric ? m.specular - m.diffuse : vec3(0.0);
  precise vec3 sum =
      (m.diffuseWeight + m.dielectricWeight) * m.diffuse + m.glossyWeight * m.glossy + m.dielectricWeight * apart;
  return sum;
}

#endif
