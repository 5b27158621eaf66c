// Explains why a pixel differs: traces one sample again on both sides and compares them quantity by quantity.
#pragma once
#include <algorithm>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/judge/explain/stages.h"
#include "host/trace/render/renderer.h"
#include "host/trace/render/settings.h"

namespace candela::explain {

/// The indices of a stage and of a quantity in it, in Explanation::stages.
struct QuantityIndex {
  std::size_t stage = 0;
  std::size_t quantity = 0;
  auto operator<=>(const QuantityIndex&) const = default;
};

struct Explanation {
  std::string scene;
  render::PixelSample sample;
  std::uint32_t seed = 0;
  render::RenderStatistics statistics;  ///< statistics of the device's replay
  render::PathTrace device;
  render::PathTrace reference;
  std::vector<Stage> stages;
  std::uint32_t replicas = 0;  ///< number of replicas by which the effect of rounding is estimated
  /// In the order of the estimator. Empty: no decision differs, and no number by more than rounding allows.
  std::optional<QuantityIndex> firstDifference;
  /// After this decision, the two paths are unrelated and nothing is compared.
  std::optional<QuantityIndex> firstDecision;
  /// The number with the maximum difference before the first difference; empty if all are bit-identical.
  std::optional<QuantityIndex> furthestBefore;

  const Quantity& at(const QuantityIndex& index) const { return stages[index.stage].quantities[index.quantity]; }
  /// Returns whether a path has more vertices than are recorded.
  bool isCut() const { return std::max(device.vertexCount, reference.vertexCount) > render::PathTrace::kMaxVertices; }
  /// Returns the result in one to three sentences.
  std::string verdict() const;
};

/// Throws UsageError, with an alternative, if `integrator` has no paths to replay.
void requirePaths(render::Integrator integrator);

/// Traces the sample on both sides. The pixel is within the image, the integrator is Integrator::path, and `reference`
/// traces replicas.
Explanation explainSample(const scene::Scene& scene, const render::RenderSettings& settings,
                          const render::PixelSample& sample, render::Renderer& device, render::Renderer& reference);
/// Compares two replays. `scene` provides names for indices. `replicas` of the reference's path show how large the
/// effect of rounding on each quantity may be; without any, the limit is kTolerance.
Explanation explainReplays(const scene::Scene& scene, const render::RenderSettings& settings,
                           const render::PixelSample& sample, const render::Replay& device,
                           const render::Replay& reference, std::span<const render::PathTrace> replicas = {});

/// Explains the pixel that differs most, with the settings of comparePaths(); returns nothing if all pixels are equal.
/// The renderers and the integrator are as for explainSample().
std::optional<Explanation> explainWorst(const scene::Scene& scene, const render::RenderSettings& settings,
                                        const verify::PixelAgreement& pixels, render::Renderer& device,
                                        render::Renderer& reference);

std::string toText(const Explanation& explanation);
nlohmann::ordered_json toJson(const Explanation& explanation);

// The output for the case that explainWorst() returns nothing.
std::string nothingToExplain(const verify::PixelAgreement& pixels);
nlohmann::ordered_json nothingJson(const scene::Scene& scene, const verify::PixelAgreement& pixels);

}  // namespace candela::explain
