// Computes quantiles of ascending values.
#include "host/base/statistics/quantiles.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace candela::statistics {

double ratio(double numerator, double denominator) { return denominator > 0 ? numerator / denominator : 0; }

double median(std::span<const double> ascending) {
  if (ascending.empty()) return 0;
  const std::size_t middle = ascending.size() / 2;
  return ascending.size() % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
}

double percentile(std::span<const double> ascending, double q) {
  if (ascending.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(ascending.size())));
  return ascending[std::max<std::size_t>(rank, 1) - 1];
}

double spread(std::span<const double> ascending) {
  return ascending.empty() ? 0 : ratio(ascending.back() - ascending.front(), median(ascending));
}

nlohmann::ordered_json durationsJson(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  return {{"count", seconds.size()},
          {"medianSeconds", median(seconds)},
          {"p90Seconds", percentile(seconds, 0.9)},
          {"p99Seconds", percentile(seconds, 0.99)},
          {"maxSeconds", percentile(seconds, 1)}};
}

}  // namespace candela::statistics
