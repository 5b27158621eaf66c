// "Same light?": a group-sequential Welch test on the image mean and on tiles, with a known rate of false alarms.
//
// Both sides render kBatchCount batches with seeds of their own and equal numbers of samples. At each of at most
// kMaxLooks looks every region's batch means are held against each other by Welch's t (Jung, Hanika and Dachsbacher,
// JCGT 2020). The level of a look is what Lan and DeMets' spending function adds there, shared among the regions after
// Sidak, so that a whole run gives a false alarm with probability at most alpha. Its argument is the information: the
// share of what is needed to see a bias of `bias` times the image mean with probability kPower, as the standard errors
// so far measure it (not the differences, on which a plan must not depend). A look with all of it, or the last one,
// spends what is left of alpha and decides; earlier ones can end a run only by a difference. What single precision
// rounds away (kRelativeTolerance of a region's mean) is no difference of light.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/statistics/welch.h"
#include "host/verify/batches.h"
#include "host/verify/region_result.h"

namespace candela::verify {

inline constexpr std::uint32_t kMaxLooks = 8;

struct LightTestOptions {
  double alpha = 1e-4;                ///< probability of a false alarm of a whole run, in (0, 1)
  double bias = 0.005;                ///< share of the image mean that must not stay unseen, > 0
  std::optional<double> timeLimit{};  ///< seconds; after it no further look begins
  std::optional<Region> watched{};    ///< a region whose means are wanted beside the tests
  bool keepFilms = false;             ///< the pictures are wanted, too
};

struct LightTestResult {
  std::uint64_t samplesPerPixel = 0;  ///< of each side, all batches together
  std::uint32_t looks = 0;
  double level = 0;                                     ///< of each region's test at the last look
  std::vector<RegionResult> regions;                    ///< the whole image by luminance first
  statistics::Summary watchedDevice, watchedReference;  ///< over the batches; empty if nothing is watched
  double information = 0;            ///< at the last look; 1: `bias` would have been seen with probability kPower
  bool outOfTime = false;            ///< the time limit came before all information was there
  bool interrupted = false;          ///< no verdict
  render::BadSampleTallies tallies;  ///< of all batches
  render::RenderStatistics deviceStatistics;
  image::Film deviceFilm, referenceFilm;  ///< of all samples; empty unless they are kept

  std::uint64_t badSamples() const { return tallies.device.samples() + tallies.reference.samples(); }
  bool differs() const { return anyDiffers(regions); }
  const RegionResult& image() const { return regions.front(); }
  const RegionResult& mostSignificant() const { return verify::mostSignificant(regions); }
};

/// Of `settings` the sample count is not used; the seed gives those of all batches.
LightTestResult testLight(const scene::Scene& scene, const render::RenderSettings& settings, render::Renderer& device,
                          render::Renderer& reference, const LightTestOptions& options,
                          const render::RenderControl& control);

/// The share, in (0, 1], of the information that is needed to see `bias` (in the units of the standard error) with
/// probability kPower at the critical value `criticalT`; 1 if nothing varies.
double informationShare(double standardError, double bias, double criticalT);

/// Samples to have at the next look, from those at this one: as many as complete the information if it grows with
/// samples, but at most so many times more that all of `looksLeft` >= 1 looks are of use; at least one more.
std::uint64_t nextSamples(std::uint64_t samples, double information, std::uint32_t looksLeft);

}  // namespace candela::verify
