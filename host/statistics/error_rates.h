// How the false alarms that a whole run may give are shared out: over simultaneous tests and over planned looks.
#pragma once
#include <cstdint>

namespace candela::statistics {

/// The level of each of `tests` tests that together give a false alarm with probability at most `alpha` (Sidak, JASA
/// 62, 1967: exact for independent tests, and valid for two-sided tests of jointly normal values of any correlation).
/// `alpha` in (0, 1), `tests` >= 1.
double sidakLevel(double alpha, std::uint64_t tests);

/// What of `alpha` may have been spent when a share `information` in [0, 1] of the planned samples is there: Lan and
/// DeMets' spending function of Pocock's kind, alpha ln(1 + (e - 1) information) (Biometrika 70, 1983).
double spentAlpha(double alpha, double information);

/// The level of look `look` (1, 2, ...) of `looks` equally spaced ones: what the spending function adds there. All
/// looks together then give a false alarm with probability at most `alpha`, whatever the correlation between them
/// (Bonferroni's inequality over the increments; exact boundaries would be a little wider).
double levelOfLook(double alpha, std::uint32_t look, std::uint32_t looks);

}  // namespace candela::statistics
