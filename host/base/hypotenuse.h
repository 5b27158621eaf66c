// The length of a vector in a plane, with the same bits on every processor.
#pragma once

#include <cmath>
#include <utility>

namespace candela {

/// Returns sqrt(a * a + b * b), to 0.6 ulp, for numbers of at most 2^511. It replaces std::hypot where films depend on
/// the result, because glibc fuses multiplications and additions of that on some processors (64-bit ARM). Source:
/// Borges, "An Improved Algorithm for hypot(a,b)", 2019, section 3; glibc 2.35 and later have the same bits on x86-64.
inline double hypotenuse(double a, double b) {
  double x = std::abs(a), y = std::abs(b);
  if (x < y) std::swap(x, y);
  if (y <= x * 0x1p-54) return x + y;
  if (y < 0x1p-459) return hypotenuse(x * 0x1p600, y * 0x1p600) * 0x1p-600;  // squares would underflow
  const double h = std::sqrt(x * x + y * y);
  if (h <= 2 * y) {
    const double over = h - y;
    return h - (x * (2 * over - x) + (over - 2 * (x - y)) * over) / (2 * h);
  }
  const double over = h - x;
  return h - (2 * over * (x - 2 * y) + ((4 * over - y) * y + over * over)) / (2 * h);
}

}  // namespace candela
