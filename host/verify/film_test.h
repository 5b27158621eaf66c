// "Same light?" of two finished films: one look at what EXR files carry, without rendering.
//
// The variance of a pixel's mean is the variance of its samples divided by their number, and pixels do not depend on
// each other, so the squared error of a region's mean is the sum over its pixels, divided by their number squared; its
// degrees of freedom are Welch and Satterthwaite's over all of its pixels. Stratified and Sobol samples spread more
// evenly than their variance says: there the errors are too large, so that false alarms are rarer than `alpha`, and
// differences must be larger to be seen. Where the films have unequal counts, each pixel is given the larger variance
// of the two: the side with fewer samples may have missed what is rare, such as fireflies, and would then seem more
// certain than it is.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/image/image.h"
#include "host/verify/region_result.h"

namespace candela::verify {

/// The images' metadata has the seed under this name.
inline constexpr const char* kSeedMetadata = "candela.seed";

struct FilmTestResult {
  double alpha = 0;                   ///< probability of a false alarm
  double level = 0;                   ///< of each region's test, after Sidak
  std::vector<RegionResult> regions;  ///< luminance: the whole image first, then tiles of 8, 16 and 32 pixels

  bool differs() const { return anyDiffers(regions); }
  const RegionResult& image() const { return regions.front(); }
  const RegionResult& mostSignificant() const { return verify::mostSignificant(regions); }
  /// One sentence that says what was found, and how sure that is.
  std::string verdict() const;
};

/// Whether an image has variance and counts at all.
bool carriesVariance(const image::Image& image);

/// Why two images of equal size cannot be tested, as a clause about "A" and "B"; none if they can. Both need variance,
/// at least two samples in every pixel, values that are finite, and seeds that are stated and not equal: with equal
/// random numbers the noise of both is the same, and its size says nothing about their difference.
std::optional<std::string> whyNotTestable(const image::Image& a, const image::Image& reference);

/// Tests whether two images, for which whyNotTestable() is empty, show the same light; `alpha` in (0, 1).
FilmTestResult testFilms(const image::Image& a, const image::Image& reference, double alpha);

/// Some lines for people, each ending in a newline; the last one is the verdict.
std::string toText(const FilmTestResult& result);
nlohmann::ordered_json toJson(const FilmTestResult& result);

}  // namespace candela::verify
