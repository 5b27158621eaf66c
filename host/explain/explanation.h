// Why a pixel differs: one sample traced again on both sides, held together quantity by quantity.
#pragma once
#include <algorithm>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/explain/stages.h"
#include "host/render/replay.h"
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
  PixelSample sample;
  std::uint32_t seed = 0;
  RenderStatistics statistics;  ///< of the device's replay
  PathTrace device;
  PathTrace reference;
  std::vector<Stage> stages;
  /// Within a stage in the order of the estimator; none: no decision differs, and no number by more than kTolerance.
  std::optional<Place> firstDifference;
  /// From it on the two paths are different ones, and nothing is compared.
  std::optional<Place> firstDecision;
  /// Of the numbers before the first difference, the one that is furthest apart; none if all are equal to the bit.
  std::optional<Place> furthestBefore;

  const Quantity& at(const Place& place) const { return stages[place.stage].quantities[place.quantity]; }
  /// Whether a path has more vertices than are kept.
  bool isCut() const { return std::max(device.vertexCount, reference.vertexCount) > PathTrace::kMostVertices; }
  /// What was found, in a sentence or three.
  std::string verdict() const;
};

/// Throws UsageError, which says what to do instead, if `integrator` has no paths to replay.
void requirePaths(Integrator integrator);

/// Traces the sample on both sides. The pixel lies within the image.
Explanation explainSample(const Scene& scene, const RenderSettings& settings, const PixelSample& sample,
                          ReplayingRenderer& device, ReplayingRenderer& reference);
/// The same from replays that are there; `scene` gives names to indices.
Explanation explainReplays(const Scene& scene, const RenderSettings& settings, const PixelSample& sample,
                           const Replay& device, const Replay& reference);

/// The pixel that differs most, by the settings with which comparePaths() saw it; none if all pixels are equal.
std::optional<Explanation> explainWorst(const Scene& scene, const RenderSettings& settings,
                                        const PixelAgreement& pixels, ReplayingRenderer& device,
                                        ReplayingRenderer& reference);

std::string toText(const Explanation& explanation);
nlohmann::ordered_json toJson(const Explanation& explanation);

// What is said where explainWorst() gives none.
std::string nothingToExplain(const PixelAgreement& pixels);
nlohmann::ordered_json nothingJson(const Scene& scene, const PixelAgreement& pixels);

}  // namespace candela::explain
