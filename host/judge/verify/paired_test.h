// The test "Same light?" on paired differences: both tracers draw the same random numbers, so that their difference has
// next to no noise.
#pragma once
#include "host/judge/verify/light_test.h"

namespace candela::verify {

/// Relative bias that must be detected unless another is requested; or kMarginFactor times the margin, or what can be
/// detected with kDefaultSamples samples per pixel or kDefaultPaths samples of the whole image, whichever is largest.
inline constexpr double kPairedBias = 5e-4;
inline constexpr double kMarginFactor = 3;
inline constexpr std::uint64_t kDefaultSamples = 32;
inline constexpr std::uint64_t kDefaultPaths = std::uint64_t{1} << 22;
/// A run has this many times as many samples at most, if noise would leave its verdict undecided.
inline constexpr std::uint64_t kPatience = 16;

/// Runs the test. The sample count of `settings` is ignored; the seeds of all batches are derived from its seed.
/// `scale`: roughly the mean luminance of the image, from other samples. The run ends if rounding excuses
/// `options.bias`, which no number of samples can detect then. Throws as Renderer::render does.
LightTestResult testLightPaired(const scene::Scene& scene, const render::RenderSettings& settings,
                                render::Renderer& device, render::Renderer& reference, const LightTestOptions& options,
                                double scale, const render::RenderControl& control);

}  // namespace candela::verify
