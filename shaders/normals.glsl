// The normals of a surface on the side of a ray: docs/light-transport.md section 4.
#ifndef CANDELA_NORMALS_GLSL
#define CANDELA_NORMALS_GLSL
#include "primitives.glsl"

// Normals on the side of wo. Dielectrics also need `outside`: wo is on the side of the primitive's own normal.
struct Normals {
  vec3 geometric;
  vec3 shading;
  bool outside;
};

Normals normalsTowards(Surface surface, vec3 wo) {
  Normals normals;
  normals.outside = dot(surface.outward, wo) > 0.0;
  normals.geometric = surface.outward;
  if (!normals.outside) normals.geometric = -normals.geometric;
  normals.shading = normals.geometric;
  if (kHasSmooth || kHasNormalMaps) {
    vec3 turned = surface.shading;
    if (!normals.outside) turned = -turned;
    bool keeps = dot(turned, wo) > 0.0 || (kHasNormalMaps && surface.isMapped);
    if (keeps) normals.shading = turned;
  }
  return normals;
}

#endif
