// Groups and shuffles cases.
#include "host/drivers/conformance/batches.h"

#include <algorithm>
#include <random>

namespace candela::conformance {
namespace {

// Fisher and Yates' shuffle. std::shuffle may differ between standard libraries.
template <class Items>
void shuffleItems(Items& items, std::mt19937& random) {
  for (std::size_t left = items.size(); left > 1; --left) std::swap(items[left - 1], items[random() % left]);
}

}  // namespace

std::deque<Batch> divide(const std::vector<const Case*>& cases, std::optional<std::uint32_t> shuffle) {
  std::deque<Batch> batches;
  for (const Case* const one : cases) {
    const auto found = std::ranges::find_if(batches,
                                            [&](const Batch& b) { return b.cases.front()->group == one->group; });
    if (found == batches.end()) {
      batches.push_back({{one}});
    } else {
      found->cases.push_back(one);
    }
  }
  if (!shuffle) return batches;
  std::mt19937 random(*shuffle);
  shuffleItems(batches, random);
  for (Batch& batch : batches) shuffleItems(batch.cases, random);
  return batches;
}

}  // namespace candela::conformance
