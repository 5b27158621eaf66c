// The test "Right light?": both tracers against the exact mean that a scene states.
//
// The device renders batches with different seeds, until the standard error of the region's mean suffices to detect
// a bias of kExactBias with probability kPower. The reference is some twenty times slower, and would need as many
// samples. Its mean is therefore estimated as the device's, minus the mean of the paired differences of the test "Same
// light?" (a control variate; Glasserman, Monte Carlo Methods in Financial Engineering, section 4.1). These differences
// have next to no noise. Where they were not measured, since `--test independent` was requested, the batches of that
// test are used.
#pragma once
#include <optional>

#include "host/scene/scene.h"
#include "host/verify/light_test.h"

namespace candela::verify {

/// Relative bias that is detected, unless LightTestOptions::bias is larger.
inline constexpr double kExactBias = kIndependentBias;

/// Both sides compared with the exact result that the scene states. All means are luminances.
struct ExactTest {
  double expected = 0;
  double device = 0;
  double reference = 0;
  double devicePValue = 1;
  double referencePValue = 1;
  double level = 0;
  std::uint64_t samplesPerPixel = 0;  ///< that the device rendered for this test; 0: none
  bool isMet() const { return devicePValue >= level && referencePValue >= level; }
};

/// Returns the pixels of the area of an exact mean, at least the one in its middle.
Region regionOf(const scene::ExactMean& exact, const render::Extent& image);

/// Runs the test on a scene that states its mean. `light`: the result of the test "Same light?" with the same options,
/// of which `watched` was the region of the exact mean. Adds the device's bad samples to `badSamples`. Returns nothing
/// if `control` stopped it. Throws as testLight does.
std::optional<ExactTest> testExactMean(const scene::Scene& scene, const render::RenderSettings& settings,
                                       render::Renderer& device, const LightTestOptions& options,
                                       const LightTestResult& light, const render::RenderControl& control,
                                       render::BadSampleTally& badSamples);

}  // namespace candela::verify
