// Normal maps: docs/light-transport.md section 5.8. Directions are in the local frame of the mapped normal, and point away
// from the surface.
#ifndef CANDELA_NORMAL_MAPS_GLSL
#define CANDELA_NORMAL_MAPS_GLSL
#include "bsdf.glsl"
#include "bump_maps.glsl"
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
  const uint needed = kGeometryTangents | kGeometryTexCoords;
  return (surface.attributes & needed) == needed;
}

// Returns the direction of the texel that `reference` selects, or interpolated among four, of any length.
vec3 mappedDirection(Surface surface, uint reference, float scale, bool isInterpolated) {
  vec3 colour = isInterpolated ? filteredTexel(reference, surface.texCoords).xyz
                               : channelValues(textureTexel(reference, surface.texCoords, surface.jitter.xy)).xyz;
  vec3 direction = 2.0 * colour - 1.0;
  vec3 bitangent = surface.tangent.w * cross(surface.shading, surface.tangent.xyz);
  return scale * (direction.x * surface.tangent.xyz + direction.y * bitangent) + direction.z * surface.shading;
}

// Replaces the shading normal of such a surface by that of the normal map that `reference` selects, unless it is 0.
// `flags`: kNormalMap... `wo` is the direction to the eye.
void mapNormal(inout Surface surface, uint reference, float scale, uint flags, vec3 wo) {
  if (reference == 0u || surface.tangent.xyz == vec3(0.0)) return;
  bool hasHeights = kHasFilteredNormals && (flags & kNormalMapHeights) != 0u;
  bool hasFacets = !kHasFilteredNormals || (flags & kNormalMapWithoutFacets) == 0u;
  vec3 sum = hasHeights ? bumpedNormal(surface, reference, scale)
                        : mappedDirection(surface, reference, scale, !hasFacets);
  float squared = dot(sum, sum);
  if (squared == 0.0) return;
  vec3 mapped = sum * (1.0 / sqrt(squared));
  if (!hasFacets) {
    surface.unmapped = surface.shading;
    bool isAway = dot(mapped, wo) * dot(surface.shading, wo) <= 0.0;
    surface.shading = isAway ? -mirroredAt(surface.shading, mapped) : mapped;
    return;
  }
  surface.shading = dot(mapped, surface.outward) < 0.0 ? mirroredAt(surface.outward, mapped) : mapped;
  surface.isMapped = true;
}

// Returns the fraction of the light from wi that the bumps of a normal map without facets do not shadow. `unmapped` is
// the normal without the map, or 0 if there is none.
float bumpShadowing(vec3 unmapped, vec3 wi) {
  if (unmapped == vec3(0.0)) return 1.0;
  float cosine = abs(unmapped.z);
  float squared = min(0.125 * max(0.0, 1.0 - cosine * cosine) / (cosine * cosine), 1.0);
  float incident = abs(dot(unmapped, wi));
  if (incident == 0.0) return 0.0;
  return 2.0 / (1.0 + sqrt(1.0 + squared * max(0.0, 1.0 - incident * incident) / (incident * incident)));
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

// Returns a direction of the diffuse lobe that is below the surface as it is scattered again, by the cosine to the
// geometric normal.
vec3 scatteredAgain(Facets facets, vec3 w) {
  vec3 normal = facets.geometric;
  float squaredSine = dot(normal.xy, normal.xy);
  if (squaredSine == 0.0) return mirroredAt(normal, w);
  float sine = sqrt(squaredSine);
  vec2 down = -normal.xy / sine;
  vec3 axis = vec3(-down.y, down.x, 0.0);
  float x = dot(w.xy, down);
  float r = length(vec2(x, w.z));
  float kappa2 = squaredSine / (1.0 + normal.z);
  float q = clamp(w.z * w.z / (r * (r + x) * kappa2), 0.0, 1.0);
  vec3 along = vec3(normal.z * down, sine);
  return dot(w, axis) * axis + r * ((2.0 * q - 1.0) * along + 2.0 * sqrt(q * (1.0 - q)) * normal);
}

// Returns f times the cosine of the diffuse lobe for the light from wi that other facets scatter, and adds the density.
vec3 scatteringByOthers(Material m, Facets facets, vec3 wo, vec3 wi, inout float pdf) {
  vec3 normal = facets.geometric;
  float kappa = 0.5 * dot(normal.xy, normal.xy) / (1.0 + normal.z);
  float cosine = kappa * max(0.0, dot(wi, normal));
  float probability;
  vec3 f = diffuseLobeOfMaterial(m, wo, probability);
  if (kHasPlastic && m.lobes.plastic.kind != kPlasticNone) f *= plasticFactor(m.lobes.plastic, max(0.0, dot(wi, normal)));
  pdf += probability * (cosine / kPi);
  return f * cosine;
}

// Returns f times the cosine for wi, on the side that `transmitted` states, with the light of other facets if there are any, and
// the sum of the densities. Reflection that is seen mirrored is also seen directly.
vec3 facetScattering(Material m, Facets facets, vec3 wo, vec3 wi, bool transmitted, out float pdf) {
  vec3 other = mirroredAt(facets.geometric, wi);
  bool isDirect = (wi.z < 0.0) == transmitted;
  bool isMirrored = facets.exist && (other.z < 0.0) == transmitted;
  uint count = (isDirect ? 1u : 0u) + (isMirrored ? 1u : 0u);
  vec3 direction = isDirect ? wi : other;
  vec3 sum = vec3(0.0);
  pdf = 0.0;
  if (facets.exist && !transmitted) sum = scatteringByOthers(m, facets, wo, wi, pdf);
  for (uint i = 0u; i < count; ++i) {
    float part;
    sum += evaluateBsdf(m, wo, direction, part) * abs(direction.z);
    pdf += part;
    direction = other;
    m = withoutDiffuse(m);
  }
  return sum;
}

// Returns the sample of the surface for a sample of the facet: a direction on the wrong side of the surface is
// replaced, and weight and pdf include the light of other facets.
BsdfSample leavingFacet(Material m, Facets facets, vec3 wo, BsdfSample next) {
  bool transmitted = next.lobe == kLobeRefract;
  bool keeps = (dot(next.wi, facets.geometric) > 0.0) != transmitted;
  if (kHasInterfaces && next.pdf == 0.0) {
    if (!keeps) next.wi = mirroredAt(facets.geometric, next.wi);
    return next;
  }
  vec3 sum = next.weight * next.pdf;
  if (!keeps) {
    next.wi = next.lobe == kLobeDiffuse ? scatteredAgain(facets, next.wi) : mirroredAt(facets.geometric, next.wi);
    sum = facetScattering(m, facets, wo, next.wi, transmitted, next.pdf);
  } else {
    vec3 other = mirroredAt(facets.geometric, next.wi);
    if (!transmitted) sum += scatteringByOthers(m, facets, wo, next.wi, next.pdf);
    if ((other.z < 0.0) == transmitted) {
      float part;
      sum += evaluateBsdf(withoutDiffuse(m), wo, other, part) * abs(other.z);
      next.pdf += part;
    }
  }
  next.weight = next.pdf > 0.0 ? sum / next.pdf : vec3(0.0);
  return next;
}

#endif
