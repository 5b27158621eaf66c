// Samples of surfaces, which several proofs take.
#pragma once
#include <span>
#include <vector>

#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/surface_material.h"

namespace candela::proof {

inline const std::vector<float> kRoughnesses{0.01f, 0.05f, 0.2f, 0.5f, 1};

/// Samples a material once for each triple of random numbers.
inline std::vector<Scattered> scattered(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo,
                                        std::span<const glm::vec3> numbers, bool outside = true,
                                        const dvec3& geometric = dvec3(0)) {
  std::vector<ScatterQuery> queries;
  for (const glm::vec3& u : numbers) queries.push_back({material, wo, u, outside, {}, geometric});
  return leaves.sample(queries);
}

inline dvec3 meanWeight(std::span<const Scattered> samples) {
  dvec3 sum(0);
  for (const Scattered& sample : samples) sum += sample.weight;
  return sum / static_cast<double>(samples.size());
}

}  // namespace candela::proof
