// Snell's law and Fresnel's equations, by amplitudes.
#include "host/reference/fresnel.h"

#include <cmath>

namespace candela::reference {

Boundary fresnel(double cosIncident, double eta) {
  const double sinTransmittedSquared = eta * eta * (1 - cosIncident * cosIncident);
  if (sinTransmittedSquared >= 1) return {1, 0};
  const double cosTransmitted = std::sqrt(1 - sinTransmittedSquared);
  if (eta == 1) return {0, cosTransmitted};
  const double perpendicular = (eta * cosIncident - cosTransmitted) / (eta * cosIncident + cosTransmitted);
  const double parallel = (cosIncident - eta * cosTransmitted) / (cosIncident + eta * cosTransmitted);
  return {(perpendicular * perpendicular + parallel * parallel) / 2, cosTransmitted};
}

}  // namespace candela::reference
