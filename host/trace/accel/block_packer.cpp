// First fit by shifts of bit masks.
#include "host/trace/accel/block_packer.h"

#include <algorithm>
#include <bit>

namespace candela::accel {
namespace {

constexpr std::uint32_t kBlockSlots = 8;
constexpr std::uint32_t kLastShift = 64 - kBlockSlots;

}  // namespace

std::uint32_t BlockPacker::place(std::uint8_t mask) {
  const auto below = static_cast<std::uint32_t>(std::countr_zero(mask));  // slots before the first that is needed
  const std::uint64_t shape = std::uint64_t{mask} >> below;
  for (;; moveWindow(kBlockSlots)) {
    for (std::uint32_t shift = 0; shift <= kLastShift; ++shift) {
      const std::uint32_t first = start_ + shift;
      if ((taken_ >> shift & shape) != 0 || first < below) continue;
      taken_ |= shape << shift;
      moveWindow(std::min(static_cast<std::uint32_t>(std::countr_one(taken_)), 63u));
      return first - below;
    }
  }
}

void BlockPacker::moveWindow(std::uint32_t slots) {
  start_ += slots;
  taken_ >>= slots;
}

}  // namespace candela::accel
