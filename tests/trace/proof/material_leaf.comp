// Lobes under proof, in the local frame. Input, four rows: (wo, material); to sample, (numbers of lobe, u and v, 1 if wo
// is outside), to evaluate, (wi, 1 if wo is outside); (throughput, number of the channel); and (geometric normal, .), 0
// without a normal map. Output, two rows: (wi, pdf) (weight, lobe), or (f, pdf) (.).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "normal_maps.glsl"

layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint evaluates; };
layout(set = 0, binding = 1, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 2, std430) writeonly buffer Outputs { vec4 outputs[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  vec4 first = inputs[4u * i];
  vec4 second = inputs[4u * i + 1u];
  vec4 third = inputs[4u * i + 2u];
  Facets facets = Facets(inputs[4u * i + 3u].xyz != vec3(0.0), inputs[4u * i + 3u].xyz);
  Material material = loadMaterial(uint(first.w));
  if (kHasDispersion && material.isSurface && material.surface.transmissionDispersionScale > 0.0) {
    chooseChannel(material, third.xyz, third.w);
  }
  prepareLobes(material, first.xyz, second.w != 0.0);
  if (evaluates != 0u) {
    float pdf;
    vec3 f;
    if (facets.exist) {
      float cosine = dot(second.xyz, facets.geometric);
      f = facetScattering(material, facets, first.xyz, second.xyz, cosine < 0.0, pdf) / abs(cosine);
    } else {
      f = evaluateBsdf(material, first.xyz, second.xyz, pdf);
    }
    outputs[2u * i] = vec4(f, pdf);
  } else {
    BsdfSample next = sampleBsdf(material, first.xyz, second.w != 0.0, second.xyz);
    if (facets.exist && next.lobe != kLobeNone) next = leavingFacet(material, facets, first.xyz, next);
    outputs[2u * i] = vec4(next.wi, next.pdf);
    outputs[2u * i + 1u] = vec4(next.weight, float(next.lobe));
  }
}
