// Integer division that rounds up.
#pragma once

namespace candela {

/// Returns the smallest number of parts of `divisor` that contain `dividend`. Both are unsigned, and their sum is
/// representable; `divisor` is positive.
template <class Unsigned>
constexpr Unsigned divideUp(Unsigned dividend, Unsigned divisor) {
  return (dividend + divisor - 1) / divisor;
}

}  // namespace candela
