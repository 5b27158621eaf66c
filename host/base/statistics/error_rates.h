// Divides the permitted probability of a false alarm among simultaneous tests and planned looks.
#pragma once
#include <cstdint>

namespace candela::statistics {

/// Returns the level of each of `tests` tests that together give a false alarm with probability at most `alpha` (Sidak,
/// JASA 62, 1967): exact for independent tests, and valid for two-sided tests of jointly normal values of any
/// correlation. `alpha` in (0, 1), `tests` >= 1.
double sidakLevel(double alpha, std::uint64_t tests);

/// Returns the p-value of `tests` tests together, of which the smallest is `pValue`: the inverse of sidakLevel().
double sidakPValue(double pValue, std::uint64_t tests);

/// Returns the part of `alpha` that may have been spent when the fraction `information`, in [0, 1], of the planned
/// samples is available: Lan and DeMets' spending function of Pocock type, alpha ln(1 + (e - 1) information)
/// (Biometrika 70, 1983).
double spentAlpha(double alpha, double information);

/// Returns the level of look `look` (1, 2, ...) of `looks` equally spaced looks: the increment of the spending
/// function. All looks together give a false alarm with probability at most `alpha`, whatever their correlation
/// (Bonferroni's inequality over the increments; exact boundaries would be slightly wider).
double levelOfLook(double alpha, std::uint32_t look, std::uint32_t looks);

/// Returns the probability of `count` or more successes in `trials` independent trials of probability `p` in (0, 1).
double binomialTail(std::uint64_t count, std::uint64_t trials, double p);

}  // namespace candela::statistics
