// Pairs of directions that are evaluated both ways.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/leaves.h"

namespace candela::proof {

/// Returns the pairs (a, b) and the pairs (b, a), where a and b are uniform on the hemisphere by the first two
/// coordinates of `first` and `second`.
inline std::pair<std::vector<DirectionPair>, std::vector<DirectionPair>> pairsBothWays(
    std::uint32_t material, std::span<const glm::vec3> first, std::span<const glm::vec3> second) {
  std::vector<DirectionPair> there, back;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const dvec3 a = directionAt(1 - double{first[i].x}, first[i].y);
    const dvec3 b = directionAt(1 - double{second[i].x}, second[i].y);
    there.push_back({material, a, b});
    back.push_back({material, b, a});
  }
  return {std::move(there), std::move(back)};
}

}  // namespace candela::proof
