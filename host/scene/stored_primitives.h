// The primitives that a scene stores: of all instances of a mesh's triangles, only those of the first.
#pragma once
#include <cstdint>
#include <vector>

#include "host/scene/primitive_list.h"

namespace candela::scene {

/// Numbers the primitives that a list stores. Data that all instances of a mesh share is indexed by these numbers, so
/// that its size does not grow with their number. Two runs share their primitives if both are placed and have the same
/// triangles, whatever their materials.
class StoredPrimitives {
 public:
  /// The list must outlive the object.
  explicit StoredPrimitives(const PrimitiveList& primitives);

  /// Returns the number of primitives that are stored.
  std::uint32_t count() const { return count_; }
  /// Returns the number, below count(), of the primitive of a list.
  std::uint32_t indexOf(std::uint32_t primitive) const;
  /// Returns the lowest index in the list of a primitive with a number.
  std::uint32_t primitiveOf(std::uint32_t number) const;
  /// Returns the number of the first primitive of a run of the list, by the index of the run.
  std::uint32_t firstOf(std::size_t run) const { return firsts_[run]; }
  /// Returns whether no earlier run has the primitives of a run.
  bool isFirst(std::size_t run) const { return isFirst_[run]; }

 private:
  const PrimitiveList* primitives_;
  std::vector<std::uint32_t> firsts_;  ///< by run
  std::vector<bool> isFirst_;          ///< by run
  std::vector<std::size_t> stored_;    ///< the runs for which isFirst() is true
  std::uint32_t count_ = 0;
};

}  // namespace candela::scene
