// The lobes of a glTF material: docs/gltf.md, "Materials".
#pragma once
#include "host/gltf/gltf_material.h"
#include "host/scene/material.h"

namespace candela::gltf {

/// The rules of docs/gltf.md. They use the lobes that NFF has, so that Fresnel's rise towards grazing angles is missing
/// from all surfaces but transmitting ones, and roughness is an exponent.
scene::Material fromGltf(const GltfMaterial& material);

/// The exponent of the Blinn-Phong distribution that is as wide as GGX with alpha = roughness^2: Walter et al.
/// (Microfacet Models for Refraction through Rough Surfaces, EGSR 2007), section 5.2. At most 2^15.
double exponentOf(double roughness);

}  // namespace candela::gltf
