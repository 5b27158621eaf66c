// Finds a small part of a list that still has a property.
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace candela::capture {

/// Indices of a list, in increasing order.
using Subset = std::vector<std::size_t>;

/// Returns a subset of 0 .. count - 1 for which `has` is true, and from which no single index can be removed, unless
/// `stop` ended the search: the subset is then the smallest one so far. `has` is true for all indices. Delta debugging
/// (Zeller and Hildebrandt 2002, section 3.2), without the tests of subsets: parts of halving size are removed.
Subset smallestSubset(std::size_t count, const std::function<bool(const Subset&)>& has,
                      const std::function<bool()>& stop);

}  // namespace candela::capture
