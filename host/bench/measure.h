// Renders variants of one scene again and again, in turn, so that a noisy machine hurts all alike.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/render/renderer.h"

namespace candela::bench {

/// One way to render a scene.
struct Variant {
  std::string name;
  RenderSettings settings;
};

/// What the renders of one variant took.
struct Measurement {
  Variant variant;
  RenderStatistics statistics{};      ///< of the last run; rays and steps are the same in every run
  std::uint64_t filmHash = 0;
  std::vector<double> traceSeconds{};   ///< one per run, ascending; without the pipeline's compilation
  std::vector<double> buildSeconds{};   ///< of the search structure, one per run, ascending
  bool agrees = true;                 ///< every run was complete and gave the image that most runs of all variants gave

  double mraysPerSecond() const;      ///< at the median time
  double msamplesPerSecond() const;
  double stepsPerRay() const;
};

/// The middle of ascending values, the mean of both middles if their number is even; 0 for none.
double median(std::span<const double> ascending);
/// (largest - smallest) / median; 0 for none.
double spread(std::span<const double> ascending);

/// Runs every variant `repeats` times, all once before any twice. One measurement per variant, in their order; none at
/// all if `control` stops a run, since what is left of it is no measurement.
/// Throws what Renderer::render throws.
std::vector<Measurement> measureInterleaved(Renderer& renderer, const Scene& scene, std::span<const Variant> variants,
                                            std::uint32_t repeats, const RenderControl& control);

}  // namespace candela::bench
