// The error of pictures relative to a converged reference, and what it is in equal time.
//
// The relMSE of a picture a of the true picture m is the mean of (a - m)^2 / (m^2 + 0.01) over pixels and channels, as
// in image::ImageComparison. A reference r of finitely many samples is noisy, too: (a - r)^2 exceeds (a - m)^2 by the
// variance of r, which is therefore estimated from the spread of the independent pictures whose mean r is, and
// subtracted. The estimate has no bias from the noise of r, except in the denominators, where the noise is that of many
// times as many samples.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "host/base/statistics/welch.h"
#include "host/image/image.h"

namespace candela::bench {

/// A converged picture and the noise that is left in it.
struct ErrorReference {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::dvec3> rgb;       ///< means of independent pictures, row by row
  std::vector<glm::dvec3> variance;  ///< of these means, channel by channel; unbiased, so not above 0 everywhere
};

/// Returns the mean of at least two independent pictures of one size and number of samples, and its variance. Throws
/// UsageError if there are fewer, or if their sizes differ.
ErrorReference errorReferenceOf(std::span<const image::Image> pictures);

/// Returns the relMSE of a picture that is independent of the reference, estimated without the reference's own
/// variance. It is negative if the picture has less noise than that estimate can show. Pixels with a value that is not
/// finite are ignored. Throws UsageError if the sizes differ.
double relMseOf(const image::Image& picture, const ErrorReference& reference);

/// Returns the relMSE of one tracer's reference relative to another one's, without the variance of either: what is left
/// of their difference when both have converged.
double relMseOf(const ErrorReference& picture, const ErrorReference& reference);

/// An estimate and its interval of 95 % confidence.
struct ConfidentValue {
  double value = 0;
  double low = 0;
  double high = 0;
};

/// The error of a tracer in equal time, as logarithms, in which errors of measurement are added.
struct ErrorInTime {
  statistics::Estimate logRelMse;
  statistics::Estimate logInefficiency;

  ConfidentValue relMse() const;  ///< mean over the pictures
  /// relMSE x seconds. The variance of Monte Carlo falls as 1 / seconds, so that this is the relMSE after one second.
  ConfidentValue inefficiency() const;
  /// Relative error after one second of work: the root of the inefficiency.
  ConfidentValue errorAfterSecond() const;
};

/// Returns the error from the relMSE of at least two pictures with equal numbers of samples and from the seconds of at
/// least two runs, each in any order. The time is the median; if it does not vary, it is regarded as known. Errors of
/// measurement are regarded as normal (Student's t, with the degrees of freedom by Welch and Satterthwaite). Returns
/// nothing if the mean relMSE or the median is not positive: pictures without noise have no error that time reduces.
std::optional<ErrorInTime> errorInTime(std::span<const double> relMse, std::span<const double> seconds);

/// Returns the ratio of the errors of two tracers in equal time, a / b, by the same assumptions.
ConfidentValue errorRatio(const ErrorInTime& a, const ErrorInTime& b);

}  // namespace candela::bench
