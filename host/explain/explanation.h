// Why a pixel differs: one sample traced again on both sides, held together quantity by quantity.
#pragma once
#include <algorithm>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/explain/stages.h"
#include "host/render/renderer.h"
#include "host/render/settings.h"

namespace candela::explain {

/// A quantity in Explanation::stages.
struct Place {
  std::size_t stage = 0;
  std::size_t quantity = 0;
  auto operator<=>(const Place&) const = default;
};

struct Explanation {
  std::string scene;
  render::PixelSample sample;
  std::uint32_t seed = 0;
  render::RenderStatistics statistics;  ///< of the device's replay
  render::PathTrace device;
  render::PathTrace reference;
  std::vector<Stage> stages;
  /// Within a stage in the order of the estimator; none: no decision differs, and no number by more than kTolerance.
  std::optional<Place> firstDifference;
  /// From it on the two paths are different ones, and nothing is compared.
  std::optional<Place> firstDecision;
  /// Of the numbers before the first difference, the one that is furthest apart; none if all are equal to the bit.
  std::optional<Place> furthestBefore;

  const Quantity& at(const Place& place) const { return stages[place.stage].quantities[place.quantity]; }
  /// Whether a path has more vertices than are kept.
  bool isCut() const { return std::max(device.vertexCount, reference.vertexCount) > render::PathTrace::kMostVertices; }
  /// What was found, in a sentence or three.
  std::string verdict() const;
};

/// Throws UsageError, which says what to do instead, if `integrator` has no paths to replay.
void requirePaths(render::Integrator integrator);

/// Traces the sample on both sides. The pixel lies within the image.
Explanation explainSample(const scene::Scene& scene, const render::RenderSettings& settings,
                          const render::PixelSample& sample, render::Renderer& device, render::Renderer& reference);
/// The same from replays that are there; `scene` gives names to indices.
Explanation explainReplays(const scene::Scene& scene, const render::RenderSettings& settings,
                           const render::PixelSample& sample, const render::Replay& device,
                           const render::Replay& reference);

/// The pixel that differs most, by the settings with which comparePaths() saw it; none if all pixels are equal.
std::optional<Explanation> explainWorst(const scene::Scene& scene, const render::RenderSettings& settings,
                                        const verify::PixelAgreement& pixels, render::Renderer& device,
                                        render::Renderer& reference);

std::string toText(const Explanation& explanation);
nlohmann::ordered_json toJson(const Explanation& explanation);

// What is said where explainWorst() gives none.
std::string nothingToExplain(const verify::PixelAgreement& pixels);
nlohmann::ordered_json nothingJson(const scene::Scene& scene, const verify::PixelAgreement& pixels);

}  // namespace candela::explain
