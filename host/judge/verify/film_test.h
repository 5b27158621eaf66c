// The test "Same light?" for two finished films: one look at the data in EXR files, without rendering.
//
// The variance of a pixel's mean is the variance of its samples divided by their number, and pixels are independent of
// each other. The squared error of a region's mean is therefore the sum over its pixels, divided by the square of their
// number; its degrees of freedom are Welch and Satterthwaite's over all of its pixels. Stratified and Sobol samples are
// more even than their variance suggests. Their errors are overestimated, so that false alarms are rarer than `alpha`,
// and differences must be larger to be detected. If the films have unequal counts, each pixel gets the larger of the
// two variances: the side with fewer samples may have missed rare events such as fireflies, and its error would be
// underestimated.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/judge/verify/light_test.h"

namespace candela::verify {

/// The metadata of the images contain the seed under this name.
inline constexpr const char* kSeedMetadata = "candela.seed";

/// Images whose light is wrong on purpose have a sentence about it under this name. They get no verdict.
inline constexpr const char* kBiasMetadata = "candela.bias";

/// The regions are the luminance of the whole image, then of tiles of 8, 16 and 32 pixels; the level is Sidak's.
struct FilmTestResult : RegionTests {
  double alpha = 0;                       ///< probability of a false alarm
  double maxOverlooked = kMaxOverlooked;  ///< fraction of the image mean

  Conclusion conclusion() const;
  /// Returns what leaves a test that found no difference undecided.
  Doubt doubt() const { return differs() ? Doubt::none : doubtOf(image(), maxOverlooked); }
  /// Returns one sentence with the result and its certainty.
  std::string verdict() const;
};

/// Returns whether an image has variances and counts.
bool carriesVariance(const image::Image& image);

/// Returns why an image, which a clause calls `name`, has no usable statistics, or nothing if it has: variances, at
/// least two samples in every pixel, finite values, and no bias on purpose.
std::optional<std::string> whyNotMeasured(const std::string& name, const image::Image& image);

/// Returns the mean luminance of a region, with its error from `variances` of one sample of each pixel and the image's
/// numbers of samples.
statistics::Estimate estimateRegion(const image::Image& image, const std::vector<float>& variances,
                                    const Region& region);

/// Returns why two images of equal size cannot be tested, as a clause about "A" and "B", or nothing if they can. Both
/// need variances, at least two samples in every pixel, finite values, no bias on purpose, and different seeds that are
/// stated: with equal random numbers, both have the same noise, which then says nothing about their difference.
std::optional<std::string> whyNotTestable(const image::Image& a, const image::Image& reference);

/// Tests whether two images for which whyNotTestable() is empty show the same light. Of `options`, only `alpha` and
/// `bias` are used.
FilmTestResult testFilms(const image::Image& a, const image::Image& reference, const LightTestOptions& options);

/// Returns lines of text, each ending in a newline; the last one is the verdict.
std::string toText(const FilmTestResult& result);
nlohmann::ordered_json toJson(const FilmTestResult& result);

}  // namespace candela::verify
