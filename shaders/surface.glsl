// Surfaces with OpenPBR's parameters: docs/light-transport.md section 5.4. Directions are in the local frame of the shading
// normal and point away from the surface.
#ifndef CANDELA_SURFACE_GLSL
#define CANDELA_SURFACE_GLSL
#include "bsdf_sample.glsl"
#include "material.glsl"
#include "microfacets.glsl"

SurfaceLobes lobesAt(SurfaceParameters s, vec3 wo) {
  SurfaceLobes lobes;
  float roughness = max(s.roughness, kMinRoughness);
  lobes.alpha = roughness * roughness;
  vec2 albedo = microfacetAlbedo(wo.z, roughness);
  float lost = (1.0 - albedo.x) / albedo.x;
  float r = (s.ior - 1.0) / (s.ior + 1.0);
  vec3 normal = min(r * r * s.specularColour, vec3(1.0));
  vec3 layer = s.specularWeight * (1.0 + normal * lost);
  vec3 metal = s.metalness * (1.0 + s.baseColour * lost);
  vec3 reflected = layer * (normal * albedo.x + (1.0 - normal) * albedo.y);
  float dielectric = 1.0 - s.metalness;
  lobes.diffuse = dielectric * max(0.0, 1.0 - largest(reflected)) * s.baseColour;
  lobes.specular = dielectric * layer * normal + metal * s.baseColour;
  lobes.grazing = dielectric * layer * (1.0 - normal) + metal * (1.0 - s.baseColour);
  float specular = luminance(lobes.specular * (albedo.x - albedo.y) + (lobes.specular + lobes.grazing) * albedo.y);
  float total = specular + luminance(lobes.diffuse);
  lobes.specularShare = total > 0.0 ? specular / total : 1.0;
  return lobes;
}

vec3 evaluateSurface(SurfaceLobes lobes, vec3 wo, vec3 wi, out float pdf) {
  pdf = 0.0;
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
  vec3 h = unit(wo + wi);
  float d = ggxDistribution(h, lobes.alpha);
  float lengthO = stretchedLength(wo, lobes.alpha);
  pdf = (1.0 - lobes.specularShare) * (wi.z / kPi) + lobes.specularShare * visibleReflectionPdf(d, wo.z, lengthO);
  vec3 reflectance = lobes.specular + lobes.grazing * fifthPower(1.0 - min(dot(wo, h), 1.0));
  return lobes.diffuse / kPi + reflectance * (d * visibility(wo, wi, lengthO, lobes.alpha));
}

// Samples a direction. numbers.x chooses the lobe, numbers.yz the direction.
BsdfSample sampleSurface(SurfaceLobes lobes, vec3 wo, vec3 numbers) {
  BsdfSample result = kAbsorbed;
  bool isDiffuse = numbers.x < 1.0 - lobes.specularShare;
  if (isDiffuse) {
    result.wi = sampleCosineHemisphere(numbers.yz);
  } else {
    vec3 h = sampleVisibleNormal(numbers.yz, wo, lobes.alpha);
    result.wi = 2.0 * dot(wo, h) * h - wo;
  }
  vec3 f = evaluateSurface(lobes, wo, result.wi, result.pdf);
  if (result.pdf <= 0.0) return kAbsorbed;
  result.weight = f * (result.wi.z / result.pdf);
  result.lobe = isDiffuse ? kLobeDiffuse : kLobeGlossy;
  return result;
}

#endif
