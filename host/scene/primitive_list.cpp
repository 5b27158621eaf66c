// Joins primitives to runs, and finds the run of a primitive.
#include "host/scene/primitive_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"

namespace candela::scene {
PrimitiveList::PrimitiveList(std::span<const Primitive> primitives) {
  for (const Primitive& primitive : primitives) push_back(primitive);
}

const PrimitiveRun& PrimitiveList::runOf(std::size_t primitive) const {
  const auto isBefore = [](std::size_t index, const PrimitiveRun& run) { return index < run.first; };
  return *(std::upper_bound(runs_.begin(), runs_.end(), primitive, isBefore) - 1);
}

std::uint32_t PrimitiveList::countOf(const PrimitiveRun& run) const {
  const std::size_t next = static_cast<std::size_t>(&run - runs_.data()) + 1;
  return (next < runs_.size() ? runs_[next].first : size_) - run.first;
}

void PrimitiveList::append(const Primitive& start, std::uint32_t count) {
  if (count == 0) return;
  if (count > kMaxSize - size_) {
    throw FileError(fmt::format("the scene has more than {} primitives", kMaxSize));
  }
  if (runs_.empty() || runs_.back().at(size_) != start) runs_.push_back({size_, start});
  size_ += count;
}

// Inline comparisons with an empty list look like an access through a null pointer to GCC 16 (-Wnull-dereference): it
// does not see that vectors of equal size without elements compare none.
bool PrimitiveList::operator==(const PrimitiveList&) const = default;

}  // namespace candela::scene
