// The primitive of a slot, whatever its kind: the intersection test that all traversals share, and the surface point
// that shading needs.
#ifndef CANDELA_PRIMITIVES_GLSL
#define CANDELA_PRIMITIVES_GLSL
#include "attributes.glsl"
#include "geometry.glsl"
#include "opacity.glsl"
#include "scene_access.glsl"

struct PrimitiveHit {
  float t;
  uint index;  // primitive index in the scene
};

bool isKind(uint kind, uint wanted) { return kOnlyKind == wanted || (kind & kKindMask) == wanted; }

float hitDistance(Ray ray, uvec4 rows[3], uint kind, bool startsHere, bool inward) {
  vec4 row0 = uintBitsToFloat(rows[0]);
  vec4 row1 = uintBitsToFloat(rows[1]);
  vec4 row2 = uintBitsToFloat(rows[2]);
  if (kHasSpheres && isKind(kind, kKindSphere)) {
    bool insideOnly = kHasInsideOnly && (kind & kFlagInsideOnly) != 0u;
    return hitSphere(ray, row0.xyz, row0.w, row1.xyz, insideOnly, startsHere);
  }
  if (kHasTriangles && isKind(kind, kKindTriangle)) {
    return startsHere ? kNoHit : hitTriangle(ray, row0.xyz, row1.xyz, row2.xyz);
  }
  if (kHasBoxes && isKind(kind, kKindBox)) return hitBox(ray, row0.xyz, row1.xyz, startsHere, inward);
  if (kHasCones && isKind(kind, kKindCone)) {
    return hitCone(ray, row0.xyz, row0.w, row1.xyz, row2.x, startsHere);
  }
  if (kHasPlanes && isKind(kind, kKindPlane)) return startsHere ? kNoHit : hitPlane(ray, row0.xyz, row1.xyz);
  return kNoHit;
}

// Returns whether --one-sided lets the ray pass: it hits the back of an opaque triangle or plane.
bool isDroppedBack(Ray ray, uvec4 rows[3], uint kind) {
  if (!kOneSided || (kind & kFlagOpaque) == 0u) return false;
  vec3 p0 = uintBitsToFloat(rows[0].xyz);
  vec3 p1 = uintBitsToFloat(rows[1].xyz);
  if (isKind(kind, kKindPlane)) return dot(p1, ray.direction) > 0.0;
  if (!isKind(kind, kKindTriangle)) return false;
  vec3 p2 = uintBitsToFloat(rows[2].xyz);
  return dot(cross(p1 - p0, p2 - p0), ray.direction) > 0.0;
}

PrimitiveHit hitRows(Ray ray, uint slot, uvec4 rows[3], uint kind) {
  float t = hitDistance(ray, rows, kind, startsOn(ray, slot), (ray.originSlot & kOriginInward) != 0u);
  if (isDroppedBack(ray, rows, kind)) t = kNoHit;
  if (kHasTransparency && t < kNoHit && (kind & kFlagTransparent) != 0u && !isThere(ray, rows, t)) t = kNoHit;
  return PrimitiveHit(t, rows[1].w);
}

uvec4[3] rowsOfSlot(uint slot) {
  uint row = primitiveRow(slot);
  return uvec4[3](sceneRow(row), sceneRow(row + 1u), sceneRow(row + 2u));
}

PrimitiveHit hitPrimitive(Ray ray, uint slot) {
  uvec4 rows[3] = rowsOfSlot(slot);
  return hitRows(ray, slot, rows, rows[2].w);
}

// The point at which a ray hit a surface, in world space.
struct Surface {
  vec3 position;
  vec3 outward;     // geometric normal with the primitive's own orientation
  vec3 shading;     // shading normal with the orientation of `outward`
  uint slot;
  uint kind;        // kind, flags and material
  uint light;       // index in the light table + 1; 0: not in the table
  uint index;       // primitive index in the scene
  bool flatSurface; // the origin of rays that start here is offset
  vec4 texCoords;   // texture coordinates, set 0 in xy and set 1 in zw; 0 if the primitive has none
  vec3 colour;      // vertex colour; 1 if the primitive has none
  vec4 tangent;     // unit vector along the texture, in the orientation of `outward`, and handedness; 0: none
  vec3 anisotropyDirection;  // direction in which the material is rougher; 0: none
  bool isMapped;    // `shading` is that of a normal map
  float facet;      // the number that chooses a facet then
  vec4 jitter;      // of textures here (x, y) and at the light that is sampled (z, w); the integrator sets it
};

void smoothTriangle(inout Surface surface, uint normalRow, vec2 weights) {
  uvec4 first = sceneRow(normalRow);
  vec3 n0 = uintBitsToFloat(first.xyz);
  vec3 n1 = sceneRowFloat(normalRow + 1u).xyz;
  vec3 n2 = sceneRowFloat(normalRow + 2u).xyz;
  vec3 interpolated = (1.0 - weights.x - weights.y) * n0 + weights.x * n1 + weights.y * n2;
  float squared = dot(interpolated, interpolated);
  vec3 shading = squared > 0.0 ? interpolated * (1.0 / sqrt(squared)) : surface.outward;
  surface.shading = dot(shading, surface.outward) < 0.0 ? -shading : shading;
  surface.light = first.w;
}

void triangleSurface(inout Surface surface, vec3 p0, vec3 p1, vec3 p2, uint extra) {
  vec2 weights = barycentrics(surface.position, p0, p1, p2);
  precise vec3 onPlane = p0 + (weights.x * (p1 - p0) + weights.y * (p2 - p0));
  surface.position = onPlane;
  surface.outward = triangleNormal(p1 - p0, p2 - p0);
  surface.shading = surface.outward;
  surface.light = extra;
  uint row = constants.firstAttributeRow + extra;
  bool hasNormals = kHasSmooth && (surface.kind & kFlagSmooth) != 0u;
  if (hasNormals) smoothTriangle(surface, row, weights);
  bool hasTexCoords = kHasTexCoords && (surface.kind & kFlagTexCoords) != 0u;
  bool hasColours = kHasColours && (surface.kind & kFlagColours) != 0u;
  bool hasTangents = kHasTangents && (surface.kind & kFlagTangents) != 0u;
  if ((hasTexCoords || hasColours || hasTangents) && !hasNormals) surface.light = sceneRow(row).x;
  if (hasTexCoords) surface.texCoords = texCoordsAt(row, surface.kind, weights);
  if (hasColours) surface.colour = colourAt(row, surface.kind, weights).xyz;
  if (hasTangents) surface.tangent = tangentAt(row, surface.kind, weights);
}

// Returns the surface point of a slot at distance t along a ray that hits it.
Surface surfaceAt(Ray ray, uint slot, float t) {
  uint row = primitiveRow(slot);
  uvec4 bits0 = sceneRow(row);
  uvec4 bits1 = sceneRow(row + 1u);
  uvec4 bits2 = sceneRow(row + 2u);
  vec4 row0 = uintBitsToFloat(bits0);
  vec4 row1 = uintBitsToFloat(bits1);
  vec4 row2 = uintBitsToFloat(bits2);
  precise vec3 position = ray.origin + t * ray.direction;
  Surface surface;
  surface.position = position;
  surface.slot = slot;
  surface.kind = bits2.w;
  surface.index = bits1.w;
  surface.light = 0u;
  surface.outward = vec3(0.0, 0.0, 1.0);
  surface.flatSurface = true;
  surface.texCoords = vec4(0.0);
  surface.colour = vec3(1.0);
  surface.tangent = vec4(0.0);
  surface.anisotropyDirection = vec3(0.0);
  surface.isMapped = false;
  surface.facet = 0.0;
  surface.jitter = vec4(0.0);
  if (kHasSpheres && isKind(surface.kind, kKindSphere)) {
    surface.outward = sphereNormal(surface.position, row0.xyz, row0.w, row1.xyz);
    if ((surface.kind & kFlagInsideOnly) != 0u) surface.outward = -surface.outward;
    surface.light = bits2.x;
    surface.flatSurface = false;
  }
  if (kHasBoxes && isKind(surface.kind, kKindBox)) {
    surface.outward = boxNormal(ray, row0.xyz, row1.xyz, startsOn(ray, slot), surface.position);
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
    triangleSurface(surface, row0.xyz, row1.xyz, row2.xyz, bits0.w);
  }
  return surface;
}

// Origin of a ray that leaves a surface in a direction.
vec3 spawnOrigin(Surface surface, vec3 direction) {
  if (!kHasFlat || !surface.flatSurface) return surface.position;
  return offsetAlong(surface.position, surface.outward, direction);
}

uint spawnSlot(Surface surface, vec3 direction) {
  return surface.slot | (dot(surface.outward, direction) < 0.0 ? kOriginInward : 0u);
}

// Spawns a ray from a surface.
Ray rayFrom(Surface surface, vec3 direction) {
  return makeRay(spawnOrigin(surface, direction), direction, spawnSlot(surface, direction));
}

// Spawns a ray from a surface in the direction wi. With `hasEnd`, it ends at the point `end`, whose distance from the
// surface is `distance`: a ray whose origin is moved off the surface has another direction and distance
// (docs/light-transport.md section 6).
Ray shadowRayFrom(Surface surface, vec3 wi, bool hasEnd, vec3 end, inout float distance) {
  vec3 origin = spawnOrigin(surface, wi);
  precise vec3 direction = wi;
  if (kHasFlat && hasEnd && surface.flatSurface) {
    precise vec3 toEnd = end - origin;
    precise float moved = sqrt(dot(toEnd, toEnd));
    if (moved > 0.0) {
      distance = moved;
      direction = toEnd / moved;
    }
  }
  return makeRay(origin, direction, spawnSlot(surface, wi));
}

#endif
