// The test "Same light?": a group-sequential Welch test on the image mean and on tiles, with a known probability of a
// false alarm.
//
// Both sides render kBatchCount batches with different seeds and equal numbers of samples. At each of at most kMaxLooks
// looks, Welch's t-test compares the batch means of every region (Jung, Hanika and Dachsbacher, JCGT 2020). The level
// of a look is the increment of Lan and DeMets' spending function, divided among the regions by Sidak's formula, so
// that a whole run gives a false alarm with probability at most alpha. The argument of the function is the information:
// the fraction of the samples that are needed to detect a bias of `bias` times the image mean with probability kPower.
// It is estimated from the standard errors so far, not from the differences, on which a plan must not depend. A look
// with all of the information, or the last one, spends the rest of alpha and decides; earlier looks can end a run only
// by finding a difference. Differences within the rounding of single precision (kRelativeTolerance of a region's mean)
// do not count, and neither do those that rounding excuses by the decisions that it changes: replicas of all samples of
// the reference measure them, as in the paired test, so that the two tests never contradict each other.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "host/base/statistics/welch.h"
#include "host/judge/verify/batches.h"
#include "host/judge/verify/conclusion.h"
#include "host/judge/verify/region_result.h"

namespace candela::verify {

/// The planned number of looks, and the maximum of the independent test.
inline constexpr std::uint32_t kMaxLooks = 8;
/// The maximum of the paired test, whose p-values hold for any number of looks: the plan fails where flips are rarer
/// than the first looks show.
inline constexpr std::uint32_t kMaxPairedLooks = 16;

/// paired: equal random numbers on both sides, docs/testing.md; independent: as described above.
enum class LightTestMethod { paired, independent };
/// Relative bias that the independent test must detect unless another is requested.
inline constexpr double kIndependentBias = 0.005;

struct LightTestOptions {
  LightTestMethod method = LightTestMethod::paired;
  double alpha = 1e-4;                ///< probability of a false alarm of a whole run, in (0, 1)
  std::optional<double> bias{};       ///< fraction of the image mean that must be detected, > 0; absent: the method's
  std::optional<double> timeLimit{};  ///< seconds; looks that would probably end later have fewer samples
  std::optional<Region> watched{};    ///< a region that is not tested, but whose means are returned
  bool keepFilms = false;             ///< return the films, too

  /// Returns the fraction of the image mean that a verdict may overlook.
  double maxOverlooked() const { return bias.value_or(kMaxOverlooked); }
};

/// The level of the regions is that of the last look.
struct LightTestResult : RegionTests {
  std::uint64_t samplesPerPixel = 0;  ///< on each side, all batches together
  std::uint32_t looks = 0;
  statistics::Summary watchedDevice,
      watchedReference;                           ///< independent: over the batches; empty without a watched region
  std::optional<RegionResult> watchedDifference;  ///< paired: of the watched region
  double bias = kIndependentBias;                 ///< that was to be detected
  double information = 0;    ///< at the last look; 1: `bias` would have been detected with probability kPower
  bool outOfTime = false;    ///< the time limit was reached before all of the information was available
  bool interrupted = false;  ///< no verdict
  render::BadSampleTallies badSamples;  ///< of all batches
  render::RenderStatistics deviceStatistics;
  image::Film deviceFilm, referenceFilm;  ///< of all samples; empty unless keepFilms is set
};

/// Runs the test. The sample count of `settings` is ignored; the seeds of all batches are derived from its seed.
LightTestResult testLight(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                          render::Renderer& reference, const LightTestOptions& options,
                          const render::RenderControl& control);

/// Returns the fraction, in (0, 1], of the information that is needed to detect `bias` (in units of the standard error)
/// with probability kPower at the critical value `criticalT`; 1 if nothing varies.
double informationFraction(double standardError, double bias, double criticalT);

/// Returns the number of samples for the next look: as many as complete the information if it grows with samples, but
/// limited such that all of `looksLeft` >= 1 looks are useful; at least one more than now.
std::uint64_t nextSamples(std::uint64_t samples, double information, std::uint32_t looksLeft);

}  // namespace candela::verify
