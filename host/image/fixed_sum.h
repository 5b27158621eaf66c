// 96-bit integers in units of 2^-40: the arithmetic of the film's sums.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

namespace candela::image {

/// A 96-bit integer in units of 2^-40, least significant word first. Sums wrap. Negative numbers are in two's
/// complement.
using FixedSum = std::array<std::uint32_t, 3>;

inline constexpr double kFixedOne = 1099511627776.0;  ///< 2^40, the value 1 in units of the sums
inline constexpr double kFilmMaximum = 1048576.0;     ///< 2^20, the maximum of a channel of one sample after scaling
/// Maximum exponent of the scale of films: variances, which are at most 2^120, then fit into binary32.
inline constexpr std::uint32_t kMaxFilmScale = 40;
inline constexpr double kTwoTo64 = 18446744073709551616.0;

inline void addFixed(FixedSum& sum, const FixedSum& term) {
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    carry += std::uint64_t{sum[i]} + term[i];
    sum[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
}

inline FixedSum negated(const FixedSum& value) {
  FixedSum result{~value[0], ~value[1], ~value[2]};
  addFixed(result, {1, 0, 0});
  return result;
}

/// Returns floor(value * 2^40) for a value in [0, 2^40]. Every step is exact: a product with a power of two, and a
/// difference of doubles that share their low bits.
inline FixedSum toFixed(double value) {
  const double scaled = std::floor(value * kFixedOne);
  const double high = std::floor(scaled / kTwoTo64);
  const auto low = static_cast<std::uint64_t>(scaled - high * kTwoTo64);
  return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32), static_cast<std::uint32_t>(high)};
}

/// Returns the value of an unsigned sum, rounded to double precision.
inline double toDouble(const FixedSum& sum) {
  const std::uint64_t low = (std::uint64_t{sum[1]} << 32) | sum[0];
  return (sum[2] * kTwoTo64 + static_cast<double>(low)) / kFixedOne;
}

/// Returns the value of a signed sum, rounded to double precision.
inline double toSignedDouble(const FixedSum& sum) {
  const bool isNegative = (sum[2] >> 31) != 0;
  return isNegative ? -toDouble(negated(sum)) : toDouble(sum);
}

}  // namespace candela::image
