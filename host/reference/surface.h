// The surface where a ray hit it: docs/light-transport.md section 4, normals.
#pragma once
#include "host/reference/mesh_attributes.h"
#include "host/reference/ray.h"
#include "host/scene/scene.h"

namespace candela::reference {

struct Surface {
  dvec3 position;
  dvec3 outwardNormal;  ///< geometric, unit, as the primitive orients it
  dvec3 facingNormal;   ///< geometric, on the side of the ray's origin
  dvec3 shadingNormal;  ///< on the same side as facingNormal; not below the ray
  bool fromOutside;     ///< the ray comes from where outwardNormal points
  std::uint32_t primitive;
  std::uint32_t material;
  MeshAttributes attributes{};  ///< 0 where the mesh gives none
};

/// `hit` is a hit of `ray`.
Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit);

}  // namespace candela::reference
