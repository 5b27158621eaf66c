// The surface at a ray's hit: docs/light-transport.md section 4, normals.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/reference/mesh_attributes.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

struct Surface {
  dvec3 position;
  dvec3 outwardNormal;  ///< geometric, unit, in the primitive's own orientation
  dvec3 facingNormal;   ///< geometric, on the side of the ray's origin
  dvec3 shadingNormal;  ///< on the same side as facingNormal; not below the ray
  bool fromOutside;     ///< the ray arrives on the side of outwardNormal
  std::uint32_t primitive;
  std::uint32_t material;
  dvec3 smoothNormal{0};             ///< interpolated vertex normal on the side of outwardNormal, or outwardNormal
  MeshAttributes attributes{};       ///< 0 if the mesh has none
  glm::dvec2 textureJitter{0};       ///< the two random numbers with which textures are looked up here,
  glm::dvec2 lightTextureJitter{0};  ///< and at the light that is sampled
  dvec3 anisotropyDirection{0};      ///< direction in which the material is rougher; 0: none
  bool isMapped = false;    ///< shadingNormal is that of a normal map with facets, and the ray may arrive below it
  dvec3 unmappedNormal{0};  ///< shadingNormal without its normal map, if this has no facets; else 0
  Contact contact = Contact::none;  ///< of the rays that start here
  double facetNumber = 0;           ///< the random number that chooses a facet of the normal map
};

/// `hit` must be a hit of `ray`.
Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit);

}  // namespace candela::reference
