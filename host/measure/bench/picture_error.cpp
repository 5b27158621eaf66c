// Sums errors over pixels, and combines them with times.
#include "host/measure/bench/picture_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/base/finite.h"
#include "host/base/statistics/quantiles.h"

namespace candela::bench {
namespace {

using glm::dvec3;
using statistics::Estimate;

constexpr double kEpsilon = 0.01;          // as in image::ImageComparison
constexpr double kErrorOfMedian = 1.2533;  // of normal values, in standard errors of their mean
constexpr double kConfidence = 0.95;

template <class A, class B>
void requireEqualSizes(const A& a, const B& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw UsageError(fmt::format("pictures of different sizes have no error: {} x {} and {} x {} pixels", a.width,
                               a.height, b.width, b.height));
}

// Means of errors, relative to a reference and without the variances of both.
class RelativeErrors {
 public:
  void add(const dvec3& value, const dvec3& expected, const dvec3& variance) {
    if (!isFinite(value) || !isFinite(expected)) return;
    const dvec3 difference = value - expected;
    const dvec3 relative = (difference * difference - variance) / (expected * expected + kEpsilon);
    sum_ += relative.x + relative.y + relative.z;
    ++pixels_;
  }
  double mean() const { return statistics::ratio(sum_, 3 * pixels_); }

 private:
  double sum_ = 0;
  double pixels_ = 0;
};

// Returns the sum of two independent values.
Estimate sumOf(const Estimate& a, const Estimate& b) {
  const statistics::WelchTest sum = statistics::welch(a, {-b.mean, b.squaredError, b.degreesOfFreedom});
  return {sum.difference, sum.standardError * sum.standardError, sum.degreesOfFreedom};
}

// Returns exp(power x) for an estimate of x.
ConfidentValue powerOf(const Estimate& logarithm, double power) {
  const double value = std::exp(power * logarithm.mean);
  if (logarithm.squaredError == 0) return {value, value, value};
  const double t = statistics::criticalT(1 - kConfidence, logarithm.degreesOfFreedom);
  const double factor = std::exp(power * t * std::sqrt(logarithm.squaredError));
  return {value, value / factor, value * factor};
}

// Returns the logarithm of a positive mean or median of `count` values. Its error is the relative error of the value.
Estimate logarithmOf(double value, double squaredError, std::size_t count) {
  return {std::log(value), squaredError / (value * value), static_cast<double>(count) - 1};
}

}  // namespace

ErrorReference errorReferenceOf(std::span<const image::Image> pictures) {
  if (pictures.size() < 2) throw UsageError("a reference needs at least two pictures, which show its variance");
  ErrorReference reference{pictures.front().width, pictures.front().height, {}, {}};
  const auto count = static_cast<double>(pictures.size());
  for (const image::Image& picture : pictures) requireEqualSizes(picture, reference);
  for (std::size_t i = 0; i < pictures.front().rgb.size(); ++i) {
    dvec3 mean(0), squares(0);
    for (const image::Image& picture : pictures) mean += dvec3(picture.rgb[i]) / count;
    for (const image::Image& picture : pictures) {
      const dvec3 deviation = dvec3(picture.rgb[i]) - mean;
      squares += deviation * deviation;
    }
    reference.rgb.push_back(mean);
    reference.variance.push_back(squares / (count * (count - 1)));
  }
  return reference;
}

double relMseOf(const image::Image& picture, const ErrorReference& reference) {
  requireEqualSizes(picture, reference);
  RelativeErrors errors;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    errors.add(dvec3(picture.rgb[i]), reference.rgb[i], reference.variance[i]);
  }
  return errors.mean();
}

double relMseOf(const ErrorReference& picture, const ErrorReference& reference) {
  requireEqualSizes(picture, reference);
  RelativeErrors errors;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    errors.add(picture.rgb[i], reference.rgb[i], picture.variance[i] + reference.variance[i]);
  }
  return errors.mean();
}

ConfidentValue ErrorInTime::relMse() const { return powerOf(logRelMse, 1); }
ConfidentValue ErrorInTime::inefficiency() const { return powerOf(logInefficiency, 1); }
ConfidentValue ErrorInTime::errorAfterSecond() const { return powerOf(logInefficiency, 0.5); }

std::optional<ErrorInTime> errorInTime(std::span<const double> relMse, std::span<const double> seconds) {
  const statistics::Summary errors = statistics::summarise(relMse);
  const statistics::Summary times = statistics::summarise(seconds);
  std::vector<double> ascending(seconds.begin(), seconds.end());
  std::ranges::sort(ascending);
  const double middle = statistics::median(ascending);
  if (!(errors.mean > 0) || !(middle > 0)) return std::nullopt;
  const Estimate logError = logarithmOf(errors.mean, errors.squaredError(), errors.count);
  const double squaredError = kErrorOfMedian * kErrorOfMedian * times.squaredError();
  return ErrorInTime{logError, sumOf(logError, logarithmOf(middle, squaredError, times.count))};
}

ConfidentValue errorRatio(const ErrorInTime& a, const ErrorInTime& b) {
  const Estimate& divisor = b.logInefficiency;
  return powerOf(sumOf(a.logInefficiency, {-divisor.mean, divisor.squaredError, divisor.degreesOfFreedom}), 0.5);
}

}  // namespace candela::bench
