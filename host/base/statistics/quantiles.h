// Medians, percentiles and the spread of repeated measurements.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

namespace candela::statistics {

/// Returns the quotient, or 0 if the denominator is not positive.
double ratio(double numerator, double denominator);

/// Returns the median of ascending values, the mean of both middle values if their number is even; 0 for none.
double median(std::span<const double> ascending);
/// Returns the smallest of ascending values such that a fraction `q` of all is not above it (nearest rank); 0 for none.
double percentile(std::span<const double> ascending, double q);
/// Returns (maximum - minimum) / median; 0 for none.
double spread(std::span<const double> ascending);

/// Returns the number of durations, in any order, and their median, 90th and 99th percentile and maximum in seconds.
nlohmann::ordered_json durationsJson(std::vector<double> seconds);

}  // namespace candela::statistics
