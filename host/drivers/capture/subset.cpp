// Removes parts of a list, first large ones, then small ones.
#include "host/drivers/capture/subset.h"

#include <algorithm>
#include <numeric>

namespace candela::capture {
namespace {

Subset without(const Subset& all, std::size_t first, std::size_t count) {
  Subset rest(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(first));
  const std::size_t end = std::min(first + count, all.size());
  rest.insert(rest.end(), all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
  return rest;
}

}  // namespace

Subset smallestSubset(std::size_t count, const std::function<bool(const Subset&)>& has,
                      const std::function<bool()>& stop) {
  Subset kept(count);
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  std::size_t size = std::max<std::size_t>(count / 2, 1);
  while (!kept.empty()) {
    const std::size_t before = kept.size();
    for (std::size_t first = 0; first < kept.size();) {
      if (stop()) return kept;
      Subset rest = without(kept, first, size);
      if (has(rest)) {
        kept = std::move(rest);
      } else {
        first += size;
      }
    }
    if (size == 1 && kept.size() == before) return kept;
    size = std::max<std::size_t>(size / 2, 1);
  }
  return kept;
}

}  // namespace candela::capture
