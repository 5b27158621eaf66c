// The results that the Vulkan specification permits ("Precision and Operation of SPIR-V Instructions"), as intervals.
#pragma once
#include <optional>

namespace candela::conformance {

/// The permitted results of a function of 32-bit floats.
struct Interval {
  double low = 0;
  double high = 0;

  bool contains(double value) const { return value >= low && value <= high; }
};

/// The distance of the two 32-bit floats around `value`; at a power of two the larger one.
double unitInLastPlace(double value);
/// The results within `ulps` units in the last place of any exact result in `exact`.
Interval withinUlps(const Interval& exact, double ulps);
Interval withinUlps(double exact, double ulps);
/// The results within `error` of `exact`.
Interval withinError(double exact, double error);
/// The two floats around `exact`, or only itself if it is a float.
Interval correctlyRounded(double exact);

// The functions that have more than one rounding, or bounds that depend on their arguments.
Interval boundOfSqrt(double x);
Interval boundOfExp2(const Interval& x);
Interval boundOfLog2(double x);
Interval boundOfPow(double x, double y);

}  // namespace candela::conformance
