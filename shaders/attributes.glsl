// Attributes of triangles' vertices, and their means at a point. shared/scene_rows.h has their layout.
#ifndef CANDELA_ATTRIBUTES_GLSL
#define CANDELA_ATTRIBUTES_GLSL
#include "placements.glsl"
#include "scene_access.glsl"

// The geometry of a triangle, and its vertices.
struct Attributes {
  uint flags;  // kGeometry...
  uvec3 vertices;
  uint normals;  // first records of arrays
  uint texCoords;
  uint colours;
  uint tangents;
};

const Attributes kNoAttributes = Attributes(0u, uvec3(0u), 0u, 0u, 0u, 0u);

uint geometryRow(uint geometry) { return constants.firstGeometryRow + geometry * kGeometryRows; }

// Returns the vertices of the triangle of a mesh whose corners have this index.
uvec3 verticesOf(uint corners) {
  if (kHasLongCorners) {
    uint word = 3u * corners;
    uint row = constants.firstAttributeRow + (word >> 2);
    uvec4 low = sceneRow(row);
    uvec4 high = sceneRow(row + 1u);
    bvec4 odd = bvec4((word & 1u) != 0u);
    uvec4 four = mix(low, uvec4(low.yzw, high.x), odd);
    return mix(four.xyz, uvec3(four.zw, odd.x ? high.y : high.x), bvec3((word & 2u) != 0u));
  }
  uvec4 both = sceneRow(constants.firstAttributeRow + (corners >> 1));
  uvec2 packed = mix(both.xy, both.zw, bvec2((corners & 1u) != 0u));
  const uint mask = kMaxPackedVertices - 1u;
  uint middle = packed.x >> kCornerBits | packed.y << (32u - kCornerBits);
  return uvec3(packed.x & mask, middle & mask, packed.y >> (2u * kCornerBits - 32u));
}

// Returns the attributes of the triangle of a geometry. `index` is the primitive index of the triangle, for an instance
// that in the mesh. There are no branches, from which lavapipe would select each member.
Attributes attributesOf(uint geometry, uint index) {
  if (!kHasAttributes) return kNoAttributes;
  uvec4 first = sceneRow(geometryRow(geometry));
  uvec4 second = uvec4(0u);
  if (kHasColours || kHasTangents) second = sceneRow(geometryRow(geometry) + 1u);
  bool isIndexed = (first.x & kGeometryIndexed) != 0u;
  uvec3 corners = first.y + 3u * index + uvec3(0u, 1u, 2u);
  uvec3 vertices = mix(corners, verticesOf(isIndexed ? first.y + index : 0u), bvec3(isIndexed));
  return Attributes(first.x, vertices, first.z, first.w, second.z, second.w);
}

// Returns the index in the light table + 1 of such a triangle or of its instance, or 0 if it is not in the table.
uint lightOf(uint geometry, uint index) {
  uvec4 second = sceneRow(geometryRow(geometry) + 1u);
  if (kHasLightInstances && second.x > 1u) return second.x - 1u;
  return second.x != 0u ? second.y + index : 0u;
}

bool hasAll(Attributes attributes, uint flags) { return (attributes.flags & flags) == flags; }

vec4 attributeRow(uint row) { return sceneRowFloat(constants.firstAttributeRow + row); }

vec4 interpolatedRows(uint firstRow, uvec3 vertices, vec2 weights) {
  vec4 at0 = attributeRow(firstRow + vertices.x);
  vec4 at1 = attributeRow(firstRow + vertices.y);
  vec4 at2 = attributeRow(firstRow + vertices.z);
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

// Returns one of the two halves of records that two vertices share.
vec2 halfRow(uint firstRow, uint vertex) {
  vec4 both = attributeRow(firstRow + (vertex >> 1));
  return mix(both.xy, both.zw, bvec2((vertex & 1u) != 0u));
}

vec2 interpolatedHalves(uint firstRow, uvec3 vertices, vec2 weights) {
  vec2 at0 = halfRow(firstRow, vertices.x);
  vec2 at1 = halfRow(firstRow, vertices.y);
  vec2 at2 = halfRow(firstRow, vertices.z);
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

// Returns the texture coordinates at a point of a triangle that has some, set 0 in x and y, set 1 in z and w.
vec4 texCoordsAt(Attributes attributes, vec2 weights) {
  if (kHasSecondTexCoords && hasAll(attributes, kGeometrySecondTexCoords)) {
    return interpolatedRows(attributes.texCoords, attributes.vertices, weights);
  }
  return vec4(interpolatedHalves(attributes.texCoords, attributes.vertices, weights), 0.0, 0.0);
}

// Returns the vertex colour at a point of a triangle that has colours.
vec4 colourAt(Attributes attributes, vec2 weights) {
  return interpolatedRows(attributes.colours, attributes.vertices, weights);
}

// Returns the mean of the directions at the vertices. Those of an instance are placed by a matrix: kNormalMatrix or
// kTangentMatrix.
vec3 directionAt(uint firstRow, uvec3 vertices, uint instance, uint matrix, vec2 weights) {
  vec3 at0 = attributeRow(firstRow + vertices.x).xyz;
  vec3 at1 = attributeRow(firstRow + vertices.y).xyz;
  vec3 at2 = attributeRow(firstRow + vertices.z).xyz;
  if (kHasInstances && instance != 0u) {
    at0 = placedDirection(instance, matrix, at0);
    at1 = placedDirection(instance, matrix, at1);
    at2 = placedDirection(instance, matrix, at2);
  }
  return (1.0 - weights.x - weights.y) * at0 + weights.x * at1 + weights.y * at2;
}

// Returns the mean of the normals at the vertices.
vec3 normalAt(Attributes attributes, uint instance, vec2 weights) {
  return directionAt(attributes.normals, attributes.vertices, instance, kNormalMatrix, weights);
}

// Returns the unit tangent at a point of a triangle that has tangents and its handedness, or 0 if the vertices' tangents
// cancel out.
vec4 tangentAt(Attributes attributes, uint instance, vec2 weights) {
  vec3 mean = directionAt(attributes.tangents, attributes.vertices, instance, kTangentMatrix, weights);
  float squared = dot(mean, mean);
  if (squared == 0.0) return vec4(0.0);
  return vec4(mean * (1.0 / sqrt(squared)), attributeRow(attributes.tangents + attributes.vertices.x).w);
}

#endif
