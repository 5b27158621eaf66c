// Smooth random numbers over space, from integers alone: the same on every machine.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace candela::generate {

/// In [0, 1), continuous with its first derivatives: uniform random values at the points with integer coordinates,
/// blended in between. |coordinates| < 2^31.
double valueNoise(const glm::dvec3& point, std::uint32_t seed);

/// In [0, 1): octaves of value noise, each of half the wavelength and half the weight of the one before; the first has
/// wavelength 1. At most 31 octaves, and coordinates such that those of the last stay in range.
double fractalNoise(const glm::dvec3& point, std::uint32_t octaves);

}  // namespace candela::generate
