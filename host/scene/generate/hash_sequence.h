// Random numbers that are computed from integers and therefore equal on every machine.
#pragma once
#include <cstdint>

namespace candela::generate {

/// A permutation of 32-bit integers that mixes all bits (C. Wellons, "Prospecting for Hash Functions", 2018:
/// lowbias32). 0 is a fixed point.
constexpr std::uint32_t mixedBits(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

/// A sequence of independent uniform values. Sequences with different seeds or positions differ. Where an expression
/// takes several values, it has braces: compilers evaluate arguments in parentheses in any order.
class HashSequence {
 public:
  explicit HashSequence(std::uint32_t seed, std::int32_t x = 0, std::int32_t y = 0)
      : state_(mixedBits(mixedBits(mixedBits(seed + kStep) ^ static_cast<std::uint32_t>(x)) ^
                         static_cast<std::uint32_t>(y))) {}

  /// Returns a value in [0, 1).
  double next() {
    state_ += kStep;
    return mixedBits(state_) * 0x1p-32;
  }
  /// Returns a value in [low, high).
  double between(double low, double high) { return low + (high - low) * next(); }

 private:
  static constexpr std::uint32_t kStep = 0x9e3779b9u;
  std::uint32_t state_;
};

}  // namespace candela::generate
