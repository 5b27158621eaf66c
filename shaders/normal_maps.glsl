// Normal maps: docs/light-transport.md section 5.8. Directions are in the local frame of the mapped normal, and point away
// from the surface.
#ifndef CANDELA_NORMAL_MAPS_GLSL
#define CANDELA_NORMAL_MAPS_GLSL
#include "bsdf.glsl"
#include "material.glsl"

// The facets of a normal map around one direction.
struct Facets {
  bool exist;
  vec3 geometric;  // normal on the side of the ray, local
};

const Facets kNoFacets = Facets(false, vec3(0.0, 0.0, 1.0));

vec3 mirroredAt(vec3 normal, vec3 w) { return w - 2.0 * dot(w, normal) * normal; }

// Returns whether the surface has all that a normal map needs, if its material has one.
bool hasTangents(Surface surface) {
  const uint needed = kFlagTangents | kFlagTexCoords;
  return (surface.kind & needed) == needed;
}

// Replaces the shading normal of such a surface by that of the normal map that `reference` selects, unless it is 0.
void mapNormal(inout Surface surface, uint reference, float scale) {
  if (reference == 0u || surface.tangent.xyz == vec3(0.0)) return;
  uvec2 texel = textureTexel(reference, surface.texCoords, surface.jitter.xy);
  vec3 direction = 2.0 * vec3(redOf(texel), greenOf(texel), blueOf(texel)) - 1.0;
  vec3 bitangent = surface.tangent.w * cross(surface.shading, surface.tangent.xyz);
  vec3 sum = scale * (direction.x * surface.tangent.xyz + direction.y * bitangent) + direction.z * surface.shading;
  float squared = dot(sum, sum);
  if (squared == 0.0) return;
  vec3 mapped = sum * (1.0 / sqrt(squared));
  surface.shading = dot(mapped, surface.outward) < 0.0 ? mirroredAt(surface.outward, mapped) : mapped;
  surface.isMapped = true;
}

// Returns the direction by which the facet sees the ray from wo: wo, or its reflection in a facet that is perpendicular to
// the surface.
vec3 seenByFacet(Facets facets, vec3 wo, float number) {
  vec3 tilt = vec3(0.0, 0.0, 1.0) - facets.geometric.z * facets.geometric;
  float directly = max(0.0, wo.z);
  float along = dot(wo, tilt);
  float mirrored = max(0.0, -along);
  precise float threshold = number * (directly + mirrored);
  if (mirrored == 0.0 || threshold < directly) return wo;
  return wo - (2.0 * along / dot(tilt, tilt)) * tilt;
}

// Returns f times the cosine for wi and for the direction whose light the surface mirrors to wi, as far as lobes scatter to
// them on the side that `transmitted` states, and the sum of their densities.
vec3 facetScattering(Material m, Facets facets, vec3 wo, vec3 wi, bool transmitted, out float pdf) {
  vec3 other = mirroredAt(facets.geometric, wi);
  bool isDirect = (wi.z < 0.0) == transmitted;
  bool isMirrored = facets.exist && (other.z < 0.0) == transmitted;
  uint count = (isDirect ? 1u : 0u) + (isMirrored ? 1u : 0u);
  vec3 direction = isDirect ? wi : other;
  vec3 sum = vec3(0.0);
  pdf = 0.0;
  for (uint i = 0u; i < count; ++i) {
    float part;
    sum += evaluateBsdf(m, wo, direction, part) * abs(direction.z);
    pdf += part;
    direction = other;
  }
  return sum;
}

// Returns the sample of the surface for a sample of the facet: its direction is mirrored if it is on the wrong side of
// the surface, and its weight and pdf include those of the direction that is mirrored to it.
BsdfSample leavingFacet(Material m, Facets facets, vec3 wo, BsdfSample next) {
  bool transmitted = next.lobe == kLobeRefract;
  bool keeps = (dot(next.wi, facets.geometric) > 0.0) != transmitted;
  vec3 other = mirroredAt(facets.geometric, next.wi);
  if ((other.z < 0.0) == transmitted) {
    float part;
    vec3 sum = next.weight * next.pdf + evaluateBsdf(m, wo, other, part) * abs(other.z);
    next.pdf += part;
    next.weight = sum / next.pdf;
  }
  if (!keeps) next.wi = other;
  return next;
}

#endif
