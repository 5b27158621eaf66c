// Combines the tolerance and the statistical test.
#include "host/cli/image_verdict.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/core/errors.h"

namespace candela::cli {
namespace {

std::string toleranceText(const ImageVerdict& verdict) {
  return fmt::format("{}: the tolerance of relMSE is {:g}", verdict.withinTolerance ? "PASS" : "FAIL",
                     *verdict.tolerance);
}

// Returns whether the image has the statistics that the test needs, or lost them because its light was changed on
// purpose.
bool isMeasurement(const image::Image& image) {
  return verify::carriesVariance(image) || image.metadata.contains(verify::kBiasMetadata);
}

// Adds the result of the test, or the reason why there is none.
void test(ImageVerdict& verdict, const Arguments& arguments, const image::Image& a, const image::Image& reference) {
  const bool asked = arguments.given.contains("--alpha");
  if (!asked && (verdict.tolerance || !isMeasurement(a) || !isMeasurement(reference))) return;
  const std::optional<std::string> obstacle = verify::whyNotTestable(a, reference);
  if (asked && obstacle) throw UsageError("--alpha: " + *obstacle);
  if (obstacle) {
    verdict.whyNoTest = *obstacle;
  } else {
    verdict.films = verify::testFilms(a, reference, arguments.verification);
  }
}

}  // namespace

ImageVerdict judgeImages(const Arguments& arguments, const image::Image& a, const image::Image& reference,
                         const image::ImageComparison& comparison) {
  ImageVerdict verdict;
  verdict.tolerance = arguments.tolerance;
  if (verdict.tolerance) {
    // If a value is not finite, its error is undefined, and the tolerance is exceeded.
    verdict.withinTolerance = comparison.notFiniteCount == 0 &&
                              comparison.relativeMeanSquaredError <= *verdict.tolerance;
  }
  test(verdict, arguments, a, reference);
  return verdict;
}

verify::Conclusion ImageVerdict::conclusion() const {
  if (!withinTolerance) return verify::Conclusion::different;
  return films ? films->conclusion() : verify::Conclusion::same;
}

std::string ImageVerdict::sentence() const {
  std::string text;
  if (tolerance) {
    text = fmt::format("relMSE is {} the tolerance of {:g}.", withinTolerance ? "within" : "NOT within", *tolerance);
  }
  if (films) text += (text.empty() ? "" : " ") + films->verdict();
  if (!whyNoTest.empty()) text += fmt::format("There is no verdict on the light: {}.", whyNoTest);
  return text.empty() ? "No verdict was requested; --tolerance requests one." : text;
}

std::string toText(const ImageVerdict& verdict) {
  std::string text;
  if (verdict.tolerance) text += toleranceText(verdict) + "\n";
  if (verdict.films) text += toText(*verdict.films);
  if (!verdict.whyNoTest.empty()) text += verdict.sentence() + "\n";
  return text;
}

void addToJson(const ImageVerdict& verdict, nlohmann::ordered_json& json) {
  json["agrees"] = verdict.isGiven() ? verify::agreesJson(verdict.conclusion()) : nlohmann::ordered_json();
  if (verdict.films) json["sameLight"] = toJson(*verdict.films);
  if (!verdict.whyNoTest.empty()) json["noVerdict"] = verdict.whyNoTest;
}

}  // namespace candela::cli
