// The verdict of `candela compare A B`: by a tolerance, by statistics, by both, or none.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "host/cli/arguments.h"
#include "host/image/metrics.h"
#include "host/verify/film_test.h"

namespace candela::cli {

/// What was asked for is judged, and all of it must be met: the tolerance if --tolerance is given, the test of both
/// films if --alpha is. Where neither is given, two films that carry variance are tested, and other images get no
/// verdict.
struct ImageVerdict {
  std::optional<double> tolerance;
  bool withinTolerance = true;
  std::optional<verify::FilmTestResult> films;
  std::string whyNoTest;  ///< of films that carry variance and were not tested all the same; else empty

  bool isGiven() const { return tolerance || films; }
  bool passes() const { return withinTolerance && !(films && films->differs()); }
  /// Sentences for people, without a newline at the end; says so if there is no verdict.
  std::string sentence() const;
};

/// Throws UsageError if --alpha is given and the images cannot be tested.
ImageVerdict judgeImages(const Arguments& arguments, const image::Image& a, const image::Image& reference,
                         const image::ImageComparison& comparison);

/// Lines for people, each ending in a newline; none without a verdict and a reason to say why.
std::string toText(const ImageVerdict& verdict);
/// Adds "pass" and "sameLight" to the report, as far as there are such verdicts.
void addToJson(const ImageVerdict& verdict, nlohmann::ordered_json& json);

}  // namespace candela::cli
