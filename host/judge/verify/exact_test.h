// The test "Right light?": both tracers against the exact mean that a scene states.
//
// The device renders batches with different seeds, until the standard error of the region's mean suffices to detect
// a bias of kExactBias with probability kPower. The reference is some twenty times slower, and would need as many
// samples. Its mean is therefore estimated as the device's, minus the mean of the paired differences of the test "Same
// light?" (a control variate; Glasserman, Monte Carlo Methods in Financial Engineering, section 4.1). These differences
// have next to no noise where rounding decides little. Where it may change the mean by more than kMaxControlMargin, an
// error of the reference would be excused with it, and the reference renders batches of its own. Where the differences
// were not measured, since `--test independent` was requested, the batches of that test are used.
#pragma once
#include <optional>

#include "host/judge/verify/light_test.h"
#include "host/scene/scene.h"

namespace candela::verify {

/// Relative bias that is detected, unless LightTestOptions::bias is larger.
inline constexpr double kExactBias = kIndependentBias;

/// Fraction of the exact mean that rounding may excuse in the paired differences; beyond, the reference renders
/// batches.
inline constexpr double kMaxControlMargin = 0.005;

/// Both sides compared with the exact result that the scene states. All means are luminances.
struct ExactTest {
  double expected = 0;
  double device = 0;
  double reference = 0;
  double devicePValue = 1;
  double referencePValue = 1;
  double level = 0;
  double detectableBias = 0;                   ///< of either side, as a fraction of `expected`; 0 if that is 0
  std::uint64_t samplesPerPixel = 0;           ///< that the device rendered for this test; 0: none
  std::uint64_t referenceSamplesPerPixel = 0;  ///< that the reference rendered for this test; 0: none

  bool deviceDiffers() const { return devicePValue < level; }
  bool referenceDiffers() const { return referencePValue < level; }
  bool isMet() const { return !deviceDiffers() && !referenceDiffers(); }
};

/// Returns the pixels of the area of an exact mean, at least the one in its middle.
Region regionOf(const scene::ExactMean& exact, const render::Extent& image);

/// Runs the test on a scene that states its mean. `light`: the result of the test "Same light?" with the same options,
/// of which `watched` was the region of the exact mean. Adds the bad samples to `badSamples`. Returns nothing if
/// `control` stopped it. Throws as testLight does.
std::optional<ExactTest> testExactMean(const scene::Scene& scene, const render::RenderSettings& settings,
                                       render::Renderer& device, render::Renderer& reference,
                                       const LightTestOptions& options, const LightTestResult& light,
                                       const render::RenderControl& control, render::BadSampleTallies& badSamples);

}  // namespace candela::verify
