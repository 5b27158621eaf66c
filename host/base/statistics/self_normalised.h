// A test of the mean of values with heavy tails, without any assumption about their variance.
//
// A value X is *heavy on left* (Bercu and Touati, "Exponential inequalities for self-normalized martingales with
// applications", Annals of Applied Probability 18, 2008) if the mean of X clipped to [-a, a] is at most 0 for every a >
// 0: symmetric values are, and so are differences of a smaller and a larger magnitude. For such values and any rate >
// 0, E exp(rate X - rate^2 X^2 / 2) <= 1 (their lemma 1). With the sum S of independent values and the sum Q of their
// squares, a mixture of exp(rate S - rate^2 Q / 2) over fixed rates is therefore a supermartingale of mean at most 1,
// and by Ville's inequality the probability that it ever reaches 1/p, at any number of values, is at most p.
#pragma once
#include <cstdint>

namespace candela::statistics {

/// The sums of independent values that are heavy on left if the hypothesis is true.
struct SelfNormalisedSum {
  double sum = 0;
  double squares = 0;
  std::uint64_t count = 0;

  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
};

/// Returns the logarithm of the mixture's value. The rates are 2^-20 to 2^28 per `scale` in steps of a factor sqrt(2),
/// with equal weights; `scale` > 0 must not depend on the values. Sums of squares from 1e-14 to 1e13 times that of the
/// scale are tested within a tenth of the power of the best rate.
double evidence(const SelfNormalisedSum& values, double scale);
/// Returns the bound of the p-value, in (0, 1]: one-sided, for all looks together.
double pValueOf(const SelfNormalisedSum& values, double scale);

/// Returns a sum at which the p-value is at most `level`, in (0, 1), for values with this sum of squares: the least at
/// which the term of a single rate suffices.
double criticalSum(double squares, double scale, double level);

}  // namespace candela::statistics
