// Surfaces with OpenPBR's parameters: docs/light-transport.md sections 5.4 to 5.15. Directions are in the local frame of the
// shading normal and point away from the surface.
#ifndef CANDELA_SURFACE_GLSL
#define CANDELA_SURFACE_GLSL
#include "bare_interface.glsl"
#include "bsdf_sample.glsl"
#include "coat.glsl"
#include "conductor.glsl"
#include "material.glsl"
#include "microfacets.glsl"
#include "plastic.glsl"
#include "sheen.glsl"
#include "thin_film.glsl"
#include "transmission.glsl"

void addCoat(SurfaceParameters s, vec3 wo, inout SurfaceLobes lobes) {
  float roughness = max(s.coatRoughness, kMinRoughness);
  lobes.coatAlpha = roughness * roughness;
  lobes.coatProbability = coatReflectance(s.coatWeight, wo.z);
  if (kHasNormalMaps && s.isCoatAlone) lobes.coatProbability = 1.0;
  lobes.coat = lobes.coatProbability / microfacetAlbedo(wo.z, roughness).x;
}

// Takes the metal out of the factors for Schlick's formula if it is a conductor.
void separateConductor(SurfaceParameters s, vec3 metal, vec3 normal, vec3 rise, inout SurfaceLobes lobes) {
  lobes.eta = s.eta;
  lobes.kappa = s.kappa;
  lobes.conductor = s.isConductor ? metal * s.baseColour : vec3(0.0);
  if (!s.isConductor) return;
  lobes.specular -= metal * normal;
  lobes.grazing -= metal * rise;
}

// `outside`: wo is on the side to which the primitive's own normal points.
SurfaceLobes lobesAt(SurfaceParameters s, vec3 wo, bool outside) {
  SurfaceLobes lobes;
  float roughness = max(s.roughness, kMinRoughness);
  lobes.alpha = vec2(roughness * roughness);
  vec2 albedo;
  if (kHasAnisotropy && s.anisotropy > 0.0) {
    lobes.alpha.x = mix(lobes.alpha.y, 1.0, s.anisotropy * s.anisotropy);
    albedo = anisotropicAlbedo(wo, roughness, s.anisotropy, lobes.alpha);
  } else {
    albedo = microfacetAlbedo(wo.z, roughness);
  }
  float lost = (1.0 - albedo.x) / albedo.x;
  float r = (s.ior - 1.0) / (s.ior + 1.0);
  vec3 normal = min(r * r * s.specularColour, vec3(1.0));
  vec3 rise = 1.0 - normal;
  vec3 compensated = normal;
  float weight = s.specularWeight;
  vec3 metalNormal = s.baseColour;
  vec3 metalRise = 1.0 - s.baseColour;
  FilmOnGlass film = FilmOnGlass(0.0, vec3(0.0), vec3(0.0));
  if (kHasFilm && s.filmWeight > 0.0 && s.filmThickness > 0.0) {
    float cosine = filmCosine(s, wo.z, outside);
    film.weight = s.filmWeight;
    film.absorbed = (1.0 - s.filmWeight) * weight * (largest(normal) - normal);
    compensated = addFilm(s, cosine, weight, normal, rise, film.reflectance);
    float metalWeight = 1.0;
    vec3 onMetal;
    addFilm(s, cosine, metalWeight, metalNormal, metalRise, onMetal);
  }
  if (kHasConductors && s.isConductor) {
    metalNormal = s.baseColour * conductorReflectance(1.0, s.eta, s.kappa);
    metalRise = s.baseColour - metalNormal;
  }
  vec3 layer = weight * (1.0 + compensated * lost);
  vec3 metal = s.metalness * (1.0 + metalNormal * lost);
  vec3 reflected = layer * (normal * albedo.x + rise * albedo.y);
  float glass = kHasTransmission ? (1.0 - s.metalness) * s.transmissionWeight : 0.0;
  float opaque = 1.0 - s.metalness - glass;
  lobes.diffuse = opaque * max(0.0, 1.0 - largest(reflected)) * s.baseColour;
  lobes.specular = opaque * layer * normal + metal * metalNormal;
  lobes.grazing = opaque * layer * rise + metal * metalRise;
  float specular = luminance(lobes.specular * albedo.x + lobes.grazing * albedo.y);
  lobes.plastic.kind = kPlasticNone;
  if (kHasPlastic && s.plastic.x != 0.0) specular = addPlastic(s, wo, lobes);
  if (kHasConductors) separateConductor(s, metal, metalNormal, metalRise, lobes);
  float diffuse = luminance(lobes.diffuse);
  float transmitting = 0.0;
  if (kHasTransmission) {
    lobes.glass =
        glassAt(s, wo, weight * normal, weight * rise, film, glass, albedo, roughness, lobes.alpha, outside);
    float reflecting = weight * largest(normal * albedo.x + rise * albedo.y);
    transmitting = glass * mix(luminance(s.baseColour), 1.0, reflecting);
  }
  lobes.coatProbability = 0.0;
  if (kHasCoat) addCoat(s, wo, lobes);
  float below = 1.0 - lobes.coatProbability;
  float total = diffuse + specular + transmitting;
  lobes.sheenProbability = 0.0;
  if (kHasSheen) {
    float sheen = addSheen(s, wo, lobes);
    lobes.sheenProbability = sheen > 0.0 ? below * (sheen / (sheen + lobes.belowSheen * total)) : 0.0;
    below -= lobes.sheenProbability;
  }
  float perUnit = total > 0.0 ? below / total : 0.0;
  lobes.diffuseProbability = diffuse * perUnit;
  if (kHasNormalMaps && s.lacksDiffuse) {
    lobes.diffuse = vec3(0.0);
    lobes.diffuseProbability = 0.0;
  }
  lobes.glassProbability = transmitting * perUnit;
  lobes.specularProbability = total > 0.0 ? specular * perUnit : below;
  return lobes;
}

// Returns f and the pdf of the lobes below sheen and coat, for wi.z > 0.
vec3 evaluateBase(SurfaceLobes lobes, vec3 wo, vec3 wi, vec3 h, out float pdf) {
  float cosOH = min(dot(wo, h), 1.0);
  vec3 metal = vec3(0.0);  // before the rest, because it needs many registers
  if (kHasConductors && largest(lobes.conductor) > 0.0) {
    metal = lobes.conductor * conductorReflectance(cosOH, lobes.eta, lobes.kappa);
  }
  float d = ggxDistribution(h, lobes.alpha);
  float lengthO = stretchedLength(wo, lobes.alpha);
  vec3 reflectance = lobes.specular + lobes.grazing * fifthPower(1.0 - cosOH);
  if (kHasConductors) reflectance += metal;
  float probability = lobes.specularProbability;
  if (kHasTransmission) {
    float schlick = schlickOf(lobes.glass, cosOH);
    reflectance += glassReflectance(lobes.glass, schlick);
    probability += lobes.glassProbability * reflectionProbability(keptByGlass(lobes.glass, schlick));
  }
  pdf = lobes.diffuseProbability * (wi.z / kPi) + probability * visibleReflectionPdf(d, wo.z, lengthO);
  return lobes.diffuse / kPi + reflectance * (d * visibility(wo, wi, lengthO, lobes.alpha));
}

vec3 evaluateReflection(SurfaceLobes lobes, vec3 wo, vec3 wi, out float pdf) {
  vec3 h = unit(wo + wi);
  vec3 f;
  if (kHasPlastic && lobes.plastic.kind != kPlasticNone) {
    f = evaluatePlastic(lobes, wo, wi, pdf);
  } else {
    f = evaluateBase(lobes, wo, wi, h, pdf);
  }
  if (kHasSheen && lobes.sheenProbability > 0.0) {
    f = f * lobes.belowSheen + evaluateSheen(lobes, wo, wi);
    pdf += lobes.sheenProbability * capPdf(1.0);
  }
  if (!kHasCoat) return f;
  float coated = ggxDistribution(h, lobes.coatAlpha);
  float coatLength = stretchedLength(wo, lobes.coatAlpha);
  pdf += lobes.coatProbability * visibleReflectionPdf(coated, wo.z, coatLength);
  return f * (1.0 - lobes.coatProbability) + lobes.coat * coated * visibility(wo, wi, coatLength, vec2(lobes.coatAlpha));
}

vec3 evaluateSurface(SurfaceLobes lobes, vec3 wo, vec3 wi, out float pdf) {
  pdf = 0.0;
  if (wo.z <= 0.0) return vec3(0.0);
  if (wi.z > 0.0) return evaluateReflection(lobes, wo, wi, pdf);
  if (!kHasTransmission || wi.z == 0.0) return vec3(0.0);
  vec3 f = evaluateTransmission(lobes.glass, lobes.alpha, wo, wi, pdf);
  pdf *= lobes.glassProbability;
  return f * ((1.0 - lobes.coatProbability) * (kHasSheen ? lobes.belowSheen : 1.0));
}

// The surface's parameters with the index of refraction of a channel: section 5.13.
SurfaceParameters inChannel(SurfaceParameters s, uint channel) {
  float halfSpread = (s.ior - 1.0) * 0.025 * s.transmissionDispersionScale;
  s.ior = max(1.0, s.ior + (float(channel) - 1.0) * halfSpread);
  return s;
}

// Chooses the channel by whose index of refraction the next direction is sampled.
void chooseChannel(inout Material m, vec3 throughput, float number) {
  float sum = throughput.x + throughput.y + throughput.z;
  if (sum > 0.0) m.channelProbabilities = throughput / sum;
  precise float greenEnd = m.channelProbabilities.x + m.channelProbabilities.y;
  m.channel = number < m.channelProbabilities.x ? 0u : number < greenEnd || m.channelProbabilities.z == 0.0 ? 1u : 2u;
}

// Each channel's f is that of its own index of refraction; the pdf is that of choosing a channel and sampling by it.
vec3 evaluateChannels(Material m, vec3 wo, vec3 wi, out float pdf) {
  vec3 f = vec3(0.0);
  pdf = 0.0;
  for (uint channel = 0u; channel < 3u; ++channel) {
    float channelPdf;
    SurfaceLobes lobes = lobesAt(inChannel(m.surface, channel), wo, m.outside);
    f[channel] = evaluateSurface(lobes, wo, wi, channelPdf)[channel];
    pdf += m.channelProbabilities[channel] * channelPdf;
  }
  return f;
}

// Returns f of the diffuse lobe for any direction, without the factor of plastic, and the probability of the lobe.
vec3 diffuseLobe(SurfaceLobes lobes, out float probability) {
  probability = lobes.diffuseProbability;
  float below = kHasSheen && lobes.sheenProbability > 0.0 ? lobes.belowSheen : 1.0;
  return lobes.diffuse * (below * (1.0 - lobes.coatProbability) / kPi);
}

vec3 diffuseLobeOfMaterial(Material m, vec3 wo, out float probability) {
  if (!kHasDispersion || m.surface.transmissionDispersionScale <= 0.0) return diffuseLobe(m.lobes, probability);
  vec3 f = vec3(0.0);
  probability = 0.0;
  for (uint channel = 0u; channel < 3u; ++channel) {
    float part;
    f[channel] = diffuseLobe(lobesAt(inChannel(m.surface, channel), wo, m.outside), part)[channel];
    probability += m.channelProbabilities[channel] * part;
  }
  return f;
}

Material withoutDiffuse(Material m) {
  m.surface.lacksDiffuse = true;
  m.lobes.diffuse = vec3(0.0);
  m.lobes.diffuseProbability = 0.0;
  return m;
}

// Chooses a lobe by numbers.x, and its direction by numbers.yz. Pdf and weight remain to be computed.
BsdfSample sampleLobes(SurfaceLobes lobes, vec3 wo, vec3 numbers) {
  BsdfSample result = kAbsorbed;
  precise float sheenEnd = lobes.coatProbability + lobes.sheenProbability;
  precise float diffuseEnd = sheenEnd + lobes.diffuseProbability;
  bool coated = kHasCoat && numbers.x < lobes.coatProbability;
  bool isSheen = kHasSheen && !coated && numbers.x < sheenEnd;
  bool isDiffuse = !coated && !isSheen && numbers.x < diffuseEnd;
  bool transmitted = false;
  if (isSheen) {
    result.wi = sampleCap(numbers.yz, 1.0);
  } else if (isDiffuse) {
    result.wi = sampleCosineHemisphere(numbers.yz);
  } else {
    vec3 h;
    if (kHasPlastic && !coated && lobes.plastic.kind != kPlasticNone) {
      h = sampleSeparableNormal(lobes.plastic.kind == kPlasticBeckmann, numbers.yz, wo, lobes.alpha);
    } else {
      h = sampleVisibleNormal(numbers.yz, wo, coated ? vec2(lobes.coatAlpha) : lobes.alpha);
    }
    float cosOH = min(dot(wo, h), 1.0);
    result.wi = 2.0 * cosOH * h - wo;
    if (kHasTransmission && !coated) {
      float reflecting = reflectionProbability(keptByGlass(lobes.glass, schlickOf(lobes.glass, cosOH)));
      transmitted = numbers.x >= 1.0 - lobes.glassProbability * (1.0 - reflecting);
      if (transmitted) result.wi = transmittedDirection(lobes.glass, wo, h, cosOH, result.wi);
    }
  }
  if ((result.wi.z < 0.0) != transmitted) return kAbsorbed;
  result.lobe = transmitted ? kLobeRefract
                : isSheen   ? kLobeSheen
                : isDiffuse ? kLobeDiffuse
                : coated    ? kLobeCoat
                            : kLobeGlossy;
  return result;
}

// Returns f and the pdf of a material with surface parameters.
vec3 evaluateSurfaceMaterial(Material m, vec3 wo, vec3 wi, out float pdf) {
  if (isBareInterface(m.surface)) return evaluateInterface(m.surface, m.lobes.alpha, m.outside, wo, wi, pdf);
  if (kHasDispersion && m.surface.transmissionDispersionScale > 0.0) return evaluateChannels(m, wo, wi, pdf);
  return evaluateSurface(m.lobes, wo, wi, pdf);
}

BsdfSample sampleSurfaceMaterial(Material m, vec3 wo, vec3 numbers) {
  if (isBareInterface(m.surface)) return sampleInterface(m.surface, m.lobes.alpha, m.outside, wo, numbers);
  BsdfSample result = sampleLobes(m.lobes, wo, numbers);
  if (result.lobe == kLobeNone) return kAbsorbed;
  vec3 f = evaluateSurfaceMaterial(m, wo, result.wi, result.pdf);
  if (result.pdf <= 0.0) return kAbsorbed;
  result.weight = f * (abs(result.wi.z) / result.pdf);
  return result;
}

#endif
