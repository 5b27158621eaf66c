// Bump maps, normal maps of heights: docs/light-transport.md section 5.8.
#ifndef CANDELA_BUMP_MAPS_GLSL
#define CANDELA_BUMP_MAPS_GLSL
#include "attributes.glsl"
#include "surface_point.glsl"
#include "textures.glsl"

// Returns the derivatives by s and t of the red that a reference has, interpolated among four texels.
vec2 gradientOfRed(Lookup at) {
  vec2 weight = nextTexelWeights(at);
  float upperLeft = redOf(texelAt(at, vec2(-0.5)));
  float upperRight = redOf(texelAt(at, vec2(0.5, -0.5)));
  float lowerLeft = redOf(texelAt(at, vec2(-0.5, 0.5)));
  float lowerRight = redOf(texelAt(at, vec2(0.5)));
  return vec2(at.size) * vec2(mix(upperRight - upperLeft, lowerRight - lowerLeft, weight.y),
                              mix(lowerLeft - upperLeft, lowerRight - upperRight, weight.x));
}

// Returns the normal, of any length, of the surface that the heights of a reference displace; 0 where the triangle has
// no derivatives by the coordinates.
vec3 bumpedNormal(Surface surface, uint reference, float scale) {
  uvec4 stored[3] = rowsOfSlot(surface.slot);
  uvec4 rows[3] = placedRowsOf(surface.slot, surface.instance);
  vec3 p0 = uintBitsToFloat(rows[0].xyz);
  vec3 edge1 = uintBitsToFloat(rows[1].xyz) - p0;
  vec3 edge2 = uintBitsToFloat(rows[2].xyz) - p0;
  Attributes attributes = attributesOf(stored[0].w, indexOf(stored));
  vec2 st0 = lookupAt(reference, texCoordsAt(attributes, vec2(0.0))).st;
  vec2 side1 = lookupAt(reference, texCoordsAt(attributes, vec2(1.0, 0.0))).st - st0;
  vec2 side2 = lookupAt(reference, texCoordsAt(attributes, vec2(0.0, 1.0))).st - st0;
  float determinant = side1.x * side2.y - side1.y * side2.x;
  if (determinant == 0.0) return vec3(0.0);
  float inverse = 1.0 / determinant;
  vec3 normal = surface.shading;
  vec3 along = (side2.y * edge1 - side1.y * edge2) * inverse;
  vec3 across = (side1.x * edge2 - side2.x * edge1) * inverse;
  along -= dot(along, normal) * normal;
  across -= dot(across, normal) * normal;
  vec2 slopes = scale * gradientOfRed(lookupAt(reference, surface.texCoords));
  float area = dot(normal, cross(along, across));
  vec3 displaced = area * normal + slopes.y * cross(along, normal) + slopes.x * cross(normal, across);
  return area < 0.0 ? -displaced : displaced;
}

#endif
