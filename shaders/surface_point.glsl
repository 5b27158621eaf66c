// The point at which a ray hit a surface, as shading needs it.
#ifndef CANDELA_SURFACE_POINT_GLSL
#define CANDELA_SURFACE_POINT_GLSL
#include "attributes.glsl"
#include "hit_primitive.glsl"
#include "scene_access.glsl"

// The point at which a ray hit a surface, in world space.
struct Surface {
  vec3 position;
  vec3 outward;     // geometric normal with the primitive's own orientation
  vec3 shading;     // shading normal with the orientation of `outward`
  uint slot;
  uint instance;    // number of the instance, or 0
  uint kind;        // kind, flags and material
  uint attributes;  // kGeometry... of a triangle, or 0
  uint light;       // index in the light table + 1; 0: not in the table
  uint index;       // primitive index in the scene
  uint contact;     // kOriginBeyond or kOriginBack, if the ray hit it at once
  bool flatSurface; // the origin of rays that start here is offset
  vec4 texCoords;   // texture coordinates, set 0 in xy and set 1 in zw; 0 if the primitive has none
  vec3 colour;      // vertex colour; 1 if the primitive has none
  float alpha;      // of the vertex colour, in scenes with choices of materials
  vec4 tangent;     // unit vector along the texture, in the orientation of `outward`, and handedness; 0: none
  vec3 anisotropyDirection;  // direction in which the material is rougher; 0: none
  bool isMapped;    // `shading` is that of a normal map with facets
  vec3 unmapped;    // `shading` without its normal map, if this has no facets; else 0
  float facet;      // the number that chooses a facet then
  vec4 jitter;      // of textures here (x, y) and at the light that is sampled (z, w); the integrator sets it
};

// Cosine of a vertex normal to the geometric normal below which rounding could decide on which side it is.
const float kMinNormalCosine = 1.0 / 65536.0;

void smoothTriangle(inout Surface surface, Attributes attributes, vec2 weights) {
  vec3 mean = normalAt(attributes, surface.instance, weights);
  float squared = dot(mean, mean);
  vec3 shading = squared > 0.0 ? mean * (1.0 / sqrt(squared)) : surface.outward;
  float cosine = dot(shading, surface.outward);
  surface.shading = abs(cosine) < kMinNormalCosine ? surface.outward : cosine < 0.0 ? -shading : shading;
}

// `direction` is that of the ray, or 0 if it hit the triangle at once. `geometry` and `index` are those of the triangle's records.
void triangleSurface(inout Surface surface, vec3 direction, vec3 p0, vec3 p1, vec3 p2, uint geometry, uint index) {
  vec2 weights = meetTriangle(surface.position, direction, p0, p1, p2, surface.outward);
  surface.shading = surface.outward;
  if (kHasTriangleLights) surface.light = lightOf(geometry, index);
  Attributes attributes = attributesOf(geometry, index);
  surface.attributes = attributes.flags;
  if (kHasSmooth && hasAll(attributes, kGeometryNormals)) smoothTriangle(surface, attributes, weights);
  if (kHasTexCoords && hasAll(attributes, kGeometryTexCoords)) surface.texCoords = texCoordsAt(attributes, weights);
  if (kHasColours && hasAll(attributes, kGeometryColours)) {
    vec4 colour = colourAt(attributes, weights);
    surface.colour = colour.xyz;
    if (kHasChoices) surface.alpha = colour.w;
  }
  if (kHasTangents && hasAll(attributes, kGeometryTangents)) {
    surface.tangent = tangentAt(attributes, surface.instance, weights);
  }
}

// Returns the surface point of a ray's hit.
Surface surfaceAt(Ray ray, Hit hit) {
  uint slot = hit.slot;
  float t = hit.t;
  uvec4 rows[3] = rowsOfSlot(slot);
  uint storedIndex = indexOf(rows);
  if (kHasInstances && hit.instance != 0u) rows = placedRows(loadPlacement(hit.instance), rows);
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec4 row1 = uintBitsToFloat(rows[1]);
  vec4 row2 = uintBitsToFloat(rows[2]);
  precise vec3 position = ray.origin + t * ray.direction;
  Surface surface;
  surface.position = position;
  surface.slot = slot;
  surface.instance = hit.instance;
  surface.kind = rows[2].w;
  surface.attributes = 0u;
  surface.index = indexOf(rows);
  bool forth = ((ray.originSlot & kOriginCrosses) != 0u) != ((ray.originSlot & kOriginBack) != 0u);
  surface.contact = !kHasCoincident || t != kAtOnce ? 0u : forth ? kOriginBeyond : kOriginBack;
  surface.light = 0u;
  surface.outward = vec3(0.0, 0.0, 1.0);
  surface.flatSurface = true;
  surface.texCoords = vec4(0.0);
  surface.colour = vec3(1.0);
  surface.alpha = 1.0;
  surface.tangent = vec4(0.0);
  surface.anisotropyDirection = vec3(0.0);
  surface.isMapped = false;
  surface.unmapped = vec3(0.0);
  surface.facet = 0.0;
  surface.jitter = vec4(0.0);
  if (kHasSpheres && isKind(surface.kind, kKindSphere)) {
    surface.outward = sphereNormal(surface.position, row0.xyz, row0.w, row1.xyz);
    if ((surface.kind & kFlagInsideOnly) != 0u) surface.outward = -surface.outward;
    surface.light = rows[2].x;
    surface.flatSurface = false;
  }
  if (kHasBoxes && isKind(surface.kind, kKindBox)) {
    surface.outward = boxNormal(ray, row0.xyz, row1.xyz, t, startsOn(ray, slot), surface.position);
  }
  if (kHasCones && isKind(surface.kind, kKindCone)) {
    surface.outward = coneNormal(surface.position, row0.xyz, row0.w, row1.xyz, row2.x);
    surface.flatSurface = false;
  }
  if (kHasPlanes && isKind(surface.kind, kKindPlane)) {
    surface.position -= dot(surface.position - row0.xyz, row1.xyz) * row1.xyz;
    surface.outward = row1.xyz;
  }
  surface.shading = surface.outward;
  if (kHasTriangles && isKind(surface.kind, kKindTriangle)) {
    vec3 direction = surface.contact == 0u ? ray.direction : vec3(0.0);
    triangleSurface(surface, direction, row0.xyz, row1.xyz, row2.xyz, rows[0].w, storedIndex);
  }
  return surface;
}

#endif
