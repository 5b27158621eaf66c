// Plastic: docs/light-transport.md section 5.14. Directions are in the local frame of the shading normal.
#ifndef CANDELA_PLASTIC_GLSL
#define CANDELA_PLASTIC_GLSL
#include "fresnel.glsl"
#include "material_types.glsl"
#include "separable_microfacets.glsl"

// Returns the fraction of the light from outside at this cosine that the boundary transmits.
float plasticTransmittance(Plastic plastic, float cosine) {
  float g;
  if (plastic.kind == kPlasticSmooth) return 1.0 - fresnelReflectance(min(cosine, 1.0), plastic.ior, g);
  float scaled = clamp(cosine, 0.0, 1.0) * float(kPlasticCells);
  uint cell = min(uint(scaled), kPlasticCells - 1u);
  uint row = cell / kPlasticCellsPerRow;
  uint inRow = cell - row * kPlasticCellsPerRow;
  vec4 nodes = sceneRowFloat(plastic.firstRow + row);
  vec2 ends = inRow == 0u ? nodes.xy : inRow == 1u ? nodes.yz : nodes.zw;
  return mix(ends.x, ends.y, scaled - float(cell));
}

// Returns the factor of the diffuse lobe for light that arrives at this cosine.
float plasticFactor(Plastic plastic, float cosine) {
  return plastic.exitFactor * plasticTransmittance(plastic, cosine);
}

// Replaces the lobes below sheen and coat by those of plastic. Returns the luminance that the boundary reflects, an estimate.
float addPlastic(SurfaceParameters s, vec3 wo, inout SurfaceLobes lobes) {
  float internal = s.plastic.y;
  lobes.plastic.kind = uint(s.plastic.x);
  lobes.plastic.ior = s.ior;
  lobes.plastic.exitFactor = 1.0 / (s.ior * s.ior * (1.0 - internal));
  lobes.plastic.firstRow = constants.firstSurfaceRow + uint(s.plastic.w);
  float entering = plasticTransmittance(lobes.plastic, wo.z);
  vec3 base = s.baseColour;
  if (s.plastic.z != 0.0) base *= (1.0 - internal) / (1.0 - internal * base);
  lobes.diffuse = entering * base;
  lobes.specular = s.specularColour;
  lobes.grazing = vec3(0.0);
  return luminance(s.specularColour) * (1.0 - entering);
}

// Returns f and the pdf of plastic without sheen and coat, for wi.z > 0.
vec3 evaluatePlastic(SurfaceLobes lobes, vec3 wo, vec3 wi, out float pdf) {
  bool isBeckmann = lobes.plastic.kind == kPlasticBeckmann;
  vec3 h = unit(wo + wi);
  float cosOH = min(dot(wo, h), 1.0);
  float d = separableDistribution(isBeckmann, h, lobes.alpha);
  float maskingO = separableMasking(isBeckmann, wo, lobes.alpha);
  float normalPdf = separableNormalPdf(isBeckmann, d, maskingO, h, wo.z, cosOH);
  pdf = lobes.diffuseProbability * (wi.z / kPi) + 0.25 * lobes.specularProbability * normalPdf;
  float g;
  float reflectance = fresnelReflectance(cosOH, lobes.plastic.ior, g);
  float shape = d * maskingO * separableMasking(isBeckmann, wi, lobes.alpha) / (4.0 * wo.z * wi.z);
  return lobes.diffuse * (plasticFactor(lobes.plastic, wi.z) / kPi) + lobes.specular * (reflectance * shape);
}

#endif
