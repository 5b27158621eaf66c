// Renders variants of one scene repeatedly and interleaved, so that noise of the machine affects all of them equally.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/measure/bench/picture_error.h"
#include "host/measure/bench/warm_up.h"
#include "host/trace/render/renderer.h"

namespace candela::bench {

/// A variant of the settings for one scene.
struct Variant {
  std::string name;
  render::RenderSettings settings;
  std::string image{};  ///< variants with the same value must give the same film, bit for bit
};

/// Measurements of the renders of one variant.
struct Measurement {
  Variant variant;
  render::RenderStatistics statistics{};  ///< statistics of the last run; rays and steps are the same in every run
  std::uint64_t filmHash = 0;
  std::vector<double> traceSeconds{};  ///< one per run, ascending; without compilation of the pipeline
  std::vector<double> buildSeconds{};  ///< build times of the acceleration structure, one per preparation, ascending
  double pipelineSeconds = 0;          ///< seconds in the first run, in which the driver compiles
  WarmUpWork warmUp{};                 ///< before all runs together
  bool agrees = true;  ///< every run was complete, and its film is that of the majority of runs of the same image
  /// relMSE (compareImages) relative to the converged image; empty unless measureNoise() or measureError() has measured
  /// it.
  std::optional<double> relMse{};
  std::optional<ErrorInTime> error{};  ///< empty unless measureError() has measured it, and for images without noise

  double mraysPerSecond() const;  ///< at the median time
  double msamplesPerSecond() const;
  double stepsPerRay() const;
  /// Returns 1 / (seconds x relMSE), the efficiency of a sampling method; 0 if one of them is missing.
  double efficiency() const;
};

/// The number of times that the sessions of variants are prepared.
enum class Preparation {
  once,     ///< once: the session is kept and reset
  everyRun  ///< for each run, so that the build of the acceleration structure is measured as often as tracing
};

/// Runs every variant `repeats` times, interleaved, on GPUs each time after warmUp(). Returns one measurement per
/// variant, in their order, or none at all if `control` stops a run, since the results would be incomplete. Throws the
/// exceptions of Renderer::prepare and Session::advance.
std::vector<Measurement> measureInterleaved(render::Renderer& renderer, const scene::Scene& scene,
                                            std::span<const Variant> variants, std::uint32_t repeats,
                                            const render::RenderControl& control,
                                            Preparation preparation = Preparation::once);

/// Renders each image twice more with two other seeds, and estimates its relMSE as half of the relMSE between the two,
/// which is also valid for stratified samples. Returns false if `control` stops a run.
bool measureNoise(render::Renderer& renderer, const scene::Scene& scene, std::span<Measurement> measurements,
                  const render::RenderControl& control);

/// How many times as many samples a picture of measureError()'s reference has.
inline constexpr std::uint32_t kReferenceSamples = 8;

/// Renders `pictureCount` >= 2 pictures of each image, each with another seed, and as many pictures of
/// kReferenceSamples times as many samples with further seeds, whose mean is the reference. The times are those of at
/// least two measured runs. Returns false if `control` stops a run.
bool measureError(render::Renderer& renderer, const scene::Scene& scene, std::span<Measurement> measurements,
                  std::uint32_t pictureCount, const render::RenderControl& control);

}  // namespace candela::bench
