// Packs blocks of eight slots, some of them empty, such that the gaps of a block hold slots of other blocks.
#pragma once
#include <bit>
#include <cstdint>

namespace candela::accel {

/// First fit in a window of the last 64 slots. Slot 0 is occupied from the beginning.
class BlockPacker {
 public:
  /// Returns the start of the new block: the first slot in the window such that slot + i is free for every bit i of
  /// `mask`, which must not be 0. These slots are then occupied.
  std::uint32_t place(std::uint8_t mask);

  /// Returns the number of slots up to the last occupied one.
  std::uint32_t end() const { return start_ + static_cast<std::uint32_t>(std::bit_width(taken_)); }

 private:
  void moveWindow(std::uint32_t slots);

  /// Start of the window, which ends at the last occupied slot. Slots before it are not used any more.
  std::uint32_t start_ = 0;
  std::uint64_t taken_ = 1;  ///< bit i: slot start_ + i is occupied
};

}  // namespace candela::accel
