// Adds the light that other facets mirror or scatter.
#include "host/trace/reference/facet_scattering.h"

#include <cmath>

namespace candela::reference {
namespace {

BsdfValue timesCosine(const Bsdf& bsdf, const dvec3& wo, const dvec3& wi) {
  const BsdfValue value = bsdf.evaluate(wo, wi);
  return {value.f * std::abs(wi.z), value.pdf};
}

// Other facets mirror all lobes but the diffuse one, whose cosine for them is another.
void addOtherFacets(const Bsdf& bsdf, const NormalMapFacets& facets, const dvec3& wo, const dvec3& wi, Side side,
                    BsdfValue& value) {
  const dvec3 mirrorImage = facets.mirrored(wi);
  const bool isSeen = sideOf(mirrorImage) == side;
  const BsdfValue mirrored = isSeen ? timesCosine(bsdf, wo, mirrorImage) : BsdfValue{};
  double byOthers = 0, counted = 0;
  if (side == Side::reflection) {
    byOthers = facets.cosineByOthers(wi);
    counted = isSeen ? mirrorImage.z : 0;
  }
  const double factor = bsdf.diffuseFactor(facets.geometricCosine(wi)), factorCounted = bsdf.diffuseFactor(counted);
  const BsdfValue diffuse = bsdf.diffuseLobe();
  value.f += mirrored.f + diffuse.f * (factor * byOthers - factorCounted * counted);
  value.pdf += mirrored.pdf + diffuse.pdf * (byOthers - counted);
}

}  // namespace

BsdfValue scatteredValue(const Bsdf& bsdf, const std::optional<NormalMapFacets>& facets, const dvec3& wo,
                         const dvec3& wi, Side side) {
  BsdfValue value;
  if (!facets || sideOf(wi) == side) value = timesCosine(bsdf, wo, wi);
  if (facets) addOtherFacets(bsdf, *facets, wo, wi, side, value);
  return value;
}

dvec3 leavingDirection(const std::optional<NormalMapFacets>& facets, const SurfaceSample& sample) {
  if (!facets || facets->isOn(sideOf(sample.wi), sample.wi)) return sample.wi;
  const bool isDiffuse = sample.lobe == render::Lobe::diffuse;
  return isDiffuse ? facets->scatteredAgain(sample.wi) : facets->mirrored(sample.wi);
}

}  // namespace candela::reference
