// Chooses the facet of a normal map.
#include "host/reference/shading_frame.h"

namespace candela::reference {

ShadingFrame::ShadingFrame(const Surface& surface, const dvec3& rayDirection, Rounding& rounding)
    : frame(surface.shadingNormal, surface.anisotropyDirection),
      wo(rounding.turned(frame.toLocal(-rayDirection), kRoundingBounds.frame)) {
  if (!surface.isMapped) return;
  facets.emplace(rounding.turned(frame.toLocal(surface.facingNormal), kRoundingBounds.frame));
  const double number = rounding.absolute(surface.facetNumber, kRoundingBounds.choice);
  const bool isDirect = number < facets->directProbability(wo);
  rounding.decide(isDirect);
  if (!isDirect) wo = facets->seenByReflection(wo);
}

Side ShadingFrame::sideOf(const dvec3& wi) const {
  if (!facets) return reference::sideOf(wi);
  return facets->isOn(Side::reflection, wi) ? Side::reflection : Side::transmission;
}

}  // namespace candela::reference
