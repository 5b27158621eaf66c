// The test "Same light?" of renders A by anybody against one picture B whose pixels have variances: a converged picture
// of Candela or Mitsuba. docs/comparing-renderers.md defines it.
//
// The error of B is that of a film (film_test.h). Filters that distribute a sample to several pixels do not invalidate
// it: the sum of a region's pixels weighs each of its samples by about 1 then, too. The error of the mean of A is
// measured twice, by the differences among its renders and by B's variances with A's number of samples, and a
// difference counts only if it is significant with either. The former alone would be too small where the renders have
// missed the fireflies that B has found, and the latter alone where they found one, or where A has more noise.
#pragma once
#include <vector>

#include "host/judge/verify/render_set_test.h"

namespace candela::verify {

/// The samples of A, as far as they are known.
struct SamplesOfA {
  std::vector<std::uint32_t> counts;  ///< for each pixel, of all renders together
  std::vector<float> variances{};     ///< of the luminance of one sample; only a single render needs them
};

/// Tests at least one render against a picture for which whyNotMeasured() is empty, with equal windows and frames. The
/// regions are the luminance of the image and of tiles. Of `options`, `design` and `threads` are ignored.
SetTestResult testAgainstPicture(const RenderSet& a, const SamplesOfA& samples, const image::Image& picture,
                                 const SetTestOptions& options);

}  // namespace candela::verify
