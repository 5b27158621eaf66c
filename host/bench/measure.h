// Renders variants of one scene again and again, in turn, so that a noisy machine hurts all alike.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/render/renderer.h"

namespace candela::bench {

/// One way to render a scene.
struct Variant {
  std::string name;
  render::RenderSettings settings;
  std::string image{};  ///< of variants for which this is the same the films must be the same, bit for bit
};

/// What the renders of one variant took.
struct Measurement {
  Variant variant;
  render::RenderStatistics statistics{};  ///< of the last run; rays and steps are the same in every run
  std::uint64_t filmHash = 0;
  std::vector<double> traceSeconds{};  ///< one per run, ascending; without the pipeline's compilation
  std::vector<double> buildSeconds{};  ///< of the search structure, one per preparation, ascending
  double pipelineSeconds = 0;          ///< of the first run, in which a driver compiles
  bool agrees = true;                  ///< every run was complete and gave what most runs of the same image gave
  /// relMSE (compareImages) of the image to what it converges to; absent where nobody has measured it: measureNoise().
  std::optional<double> relMse{};

  double mraysPerSecond() const;  ///< at the median time
  double msamplesPerSecond() const;
  double stepsPerRay() const;
  /// 1 / (seconds x relMSE), the figure of merit of a way to sample; 0 without either.
  double efficiency() const;
};

/// The middle of ascending values, the mean of both middles if their number is even; 0 for none.
double median(std::span<const double> ascending);
/// The smallest of ascending values that is not below a share `q` of all (nearest rank); 0 for none.
double percentile(std::span<const double> ascending, double q);
/// (largest - smallest) / median; 0 for none.
double spread(std::span<const double> ascending);

/// What is prepared anew for each run of a variant.
enum class Preparation {
  once,     ///< nothing: its session is kept
  everyRun  ///< everything, so that the build of the search structure is measured as often as tracing
};

/// Runs every variant `repeats` times, all once before any twice. One measurement per variant, in their order; none at
/// all if `control` stops a run, since what is left of it is no measurement.
/// Throws what Renderer::prepare and Session::advance throw.
std::vector<Measurement> measureInterleaved(render::Renderer& renderer, const scene::Scene& scene,
                                            std::span<const Variant> variants, std::uint32_t repeats,
                                            const render::RenderControl& control,
                                            Preparation preparation = Preparation::once);

/// Renders each image twice more, with two other seeds, and takes half of the relMSE between the two for what either
/// has: that holds for evenly spread samples, too. False if `control` stops a run.
bool measureNoise(render::Renderer& renderer, const scene::Scene& scene, std::span<Measurement> measurements,
                  const render::RenderControl& control);

}  // namespace candela::bench
