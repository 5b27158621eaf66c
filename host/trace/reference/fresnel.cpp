// Snell's law and Fresnel's equations, by amplitudes.
#include "host/trace/reference/fresnel.h"

#include <cmath>
#include <complex>

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

glm::dvec3 conductorReflectance(double cosIncident, const glm::dvec3& ior, const glm::dvec3& extinction) {
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) {
    const std::complex<double> index(ior[c], extinction[c]);
    // Snell's law: index times the cosine of the refracted direction.
    const std::complex<double> refracted = std::sqrt(index * index - (1 - cosIncident * cosIncident));
    const std::complex<double> perpendicular = (cosIncident - refracted) / (cosIncident + refracted);
    const std::complex<double> along = index * index * cosIncident;
    const std::complex<double> parallel = (along - refracted) / (along + refracted);
    result[c] = (std::norm(perpendicular) + std::norm(parallel)) / 2;
  }
  return result;
}

}  // namespace candela::reference
