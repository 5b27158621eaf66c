// Where blocks of eight slots go of which some stay empty: into each other, so that one's gaps hold what others have.
#pragma once
#include <bit>
#include <cstdint>

namespace candela::accel {

/// First fit in a window of the last 64 slots. Slot 0 is taken from the beginning.
class BlockPacker {
 public:
  /// The slot that the new block starts with, so near the front of the window that slot + i is free, and taken from
  /// then on, for every bit i of `mask`, which must not be 0.
  std::uint32_t place(std::uint8_t mask);

  /// The number of slots up to the last one that is taken.
  std::uint32_t end() const { return start_ + static_cast<std::uint32_t>(std::bit_width(taken_)); }

 private:
  void moveWindow(std::uint32_t slots);

  std::uint32_t
      start_ = 0;  ///< of the window, which reaches to the last slot that is taken; what lies before it is left
  std::uint64_t taken_ = 1;  ///< bit i: slot start_ + i
};

}  // namespace candela::accel
