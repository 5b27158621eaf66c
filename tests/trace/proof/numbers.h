// Numbers for the functions under proof: fractions of 2^24, as the samplers make them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace candela::proof {

/// Independent and uniform in [0, 1)^3; a function of the seed.
std::vector<glm::vec3> randomNumbers(std::size_t count, std::uint32_t seed);

/// Evenly spread over [0, 1)^3, for integration: the error of a mean falls nearly as 1 / count (the rank-one lattice of
/// the generalised golden ratio in two dimensions beside a regular first coordinate).
std::vector<glm::vec3> latticeNumbers(std::size_t count);

/// Evenly spread over the unit sphere, each for the same solid angle (z regular, azimuths by the golden ratio).
std::vector<glm::dvec3> latticeDirections(std::size_t count);

}  // namespace candela::proof
