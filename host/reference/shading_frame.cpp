// Chooses the facet of a normal map.
#include "host/reference/shading_frame.h"

namespace candela::reference {

ShadingFrame::ShadingFrame(const Surface& surface, const dvec3& rayDirection, Arithmetic& arithmetic)
    : frame(surface.shadingNormal, surface.anisotropyDirection),
      wo(arithmetic.direction(frame.toLocal(-rayDirection))) {
  if (!surface.isMapped) return;
  facets.emplace(arithmetic.direction(frame.toLocal(surface.facingNormal)));
  const bool isDirect = arithmetic.choice(surface.facetNumber) < facets->directProbability(wo);
  arithmetic.decide(isDirect);
  if (!isDirect) wo = facets->seenByReflection(wo);
}

Side ShadingFrame::sideOf(const dvec3& wi) const {
  if (!facets) return reference::sideOf(wi);
  return facets->isOn(Side::reflection, wi) ? Side::reflection : Side::transmission;
}

}  // namespace candela::reference
