// Finds runs that share their primitives.
#include "host/scene/stored_primitives.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace candela::scene {

StoredPrimitives::StoredPrimitives(const PrimitiveList& primitives) : primitives_(&primitives) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> known;
  for (const PrimitiveRun& run : primitives.runs()) {
    const std::uint32_t size = primitives.countOf(run);
    std::uint32_t first = count_;
    bool isNew = true;
    if (run.start.isPlaced()) {
      const auto [entry, added] = known.try_emplace({run.start.mesh, run.start.index, size}, count_);
      first = entry->second;
      isNew = added;
    }
    firsts_.push_back(first);
    isFirst_.push_back(isNew);
    if (!isNew) continue;
    stored_.push_back(firsts_.size() - 1);
    count_ += size;
  }
}

std::uint32_t StoredPrimitives::indexOf(std::uint32_t primitive) const {
  const PrimitiveRun& run = primitives_->runOf(primitive);
  const auto index = static_cast<std::size_t>(&run - primitives_->runs().data());
  return firsts_[index] + (primitive - run.first);
}

std::uint32_t StoredPrimitives::primitiveOf(std::uint32_t number) const {
  const auto isBefore = [this](std::uint32_t index, std::size_t run) { return index < firsts_[run]; };
  const std::size_t run = *(std::upper_bound(stored_.begin(), stored_.end(), number, isBefore) - 1);
  return primitives_->runs()[run].first + (number - firsts_[run]);
}

}  // namespace candela::scene
