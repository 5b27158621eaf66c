// Smooth noise over space, computed from integers and therefore equal on every machine.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace candela::generate {

/// Returns noise in [0, 1) that is continuous with its first derivatives: uniform random values at points with integer
/// coordinates, interpolated between them. |coordinates| < 2^31.
double valueNoise(const glm::dvec3& point, std::uint32_t seed);

/// Returns a sum of octaves of value noise, in [0, 1). The first has wavelength 1; each has half the wavelength and
/// half the weight of the one before. At most 31 octaves, and coordinates such that those of the last stay in range.
double fractalNoise(const glm::dvec3& point, std::uint32_t octaves);

/// Returns 0 below `low`, 1 above `high`, and between them a cubic polynomial with level ends.
double smoothStep(double low, double high, double x);

}  // namespace candela::generate
