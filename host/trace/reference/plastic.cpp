// The base by the light that the boundary transmits.
#include "host/trace/reference/plastic.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/fresnel.h"
#include "host/trace/reference/table_axis.h"

namespace candela::reference {

PlasticLobes::PlasticLobes(const scene::SurfaceParameters& surface, const dvec3& wo)
    : plastic_(*surface.plastic),
      base_(surface.baseColour),
      specular_(surface.specularColour),
      ior_(surface.ior),
      microfacets_(plastic_.boundary, surface.roughness),
      wo_(wo),
      exitFactor_(1 / (ior_ * ior_ * (1 - double{plastic_.internalReflectance}))) {}

double PlasticLobes::fresnelReflectance(double cosine) const {
  return fresnel(std::min(cosine, 1.0), 1 / ior_).reflectance;
}

double PlasticLobes::transmittance(double cosine) const {
  if (plastic_.boundary == scene::Interface::smooth) return 1 - fresnelReflectance(cosine);
  const TableAxis axis(cosine, scene::Plastic::kNodes);
  return std::lerp(double{plastic_.transmittances[axis.node]}, double{plastic_.transmittances[axis.node + 1]},
                   axis.part);
}

dvec3 PlasticLobes::baseAlbedo() const {
  const double entering = transmittance(wo_.z);
  if (!plastic_.isNonlinear) return entering * base_;
  const double internal = plastic_.internalReflectance;
  return entering * (1 - internal) * base_ / (1.0 - internal * base_);
}

dvec3 PlasticLobes::reflected() const { return (1 - transmittance(wo_.z)) * specular_; }

dvec3 PlasticLobes::reflection(const dvec3& wi) const {
  const dvec3 h = normalize(wo_ + wi);
  return fresnelReflectance(dot(wo_, h)) * microfacets_.masked(h, wo_, wi) / (4 * wo_.z * wi.z) * specular_;
}

}  // namespace candela::reference
