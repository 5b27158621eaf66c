// Finds the first difference and the first decision that differs, and states the result in words.
#include "host/judge/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "host/base/errors.h"
#include "host/judge/explain/stages.h"
#include "host/judge/explain/value_text.h"
#include "host/scene/scene.h"
#include "host/trace/render/path_trace.h"

namespace candela::explain {
namespace {

/// Number of replicas that are compared with the exact path.
constexpr std::uint32_t kReplicaCount = 16;

Quantity* find(Stage& stage, const std::string& name) {
  const auto found = std::ranges::find(stage.quantities, name, &Quantity::name);
  return found == stage.quantities.end() ? nullptr : &*found;
}

// Up to the decision after which the replica is a different path.
void addReplica(const std::vector<Stage>& replica, std::vector<Stage>& stages) {
  for (std::size_t i = 0; i < std::min(replica.size(), stages.size()); ++i) {
    for (const Quantity& quantity : replica[i].quantities) {
      Quantity* const judged = find(stages[i], quantity.name);
      const bool parts = quantity.kind == Quantity::Kind::decision && quantity.differs;
      if (judged && parts) judged->undecidable = true;
      if (parts) return;
      if (judged) judged->spread = std::max(judged->spread, quantity.apart);
    }
  }
}

/// Sets the spread of every quantity of `stages`, and which decisions replicas take differently; differences are then
/// judged by Quantity::allowed(). Without replicas nothing changes.
void judgeByReplicas(std::span<const render::PathTrace> replicas, const render::PathTrace& reference,
                     const scene::Scene& scene, std::vector<Stage>& stages) {
  if (replicas.empty()) return;
  for (const render::PathTrace& replica : replicas) addReplica(stagesOf(replica, reference, scene), stages);
  for (Stage& stage : stages) {
    for (Quantity& quantity : stage.quantities) {
      if (quantity.kind == Quantity::Kind::number) quantity.differs = quantity.apart > quantity.allowed();
    }
  }
}

// Processes the quantities up to the decision at which the two paths diverge.
void findDifferences(Explanation& result) {
  for (std::size_t stage = 0; stage < result.stages.size(); ++stage) {
    const std::vector<Quantity>& quantities = result.stages[stage].quantities;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      const Quantity& quantity = quantities[i];
      const QuantityIndex index{stage, i};
      if (quantity.differs && !result.firstDifference) result.firstDifference = index;
      if (quantity.differs && quantity.kind == Quantity::Kind::decision) {
        result.firstDecision = index;
        return;
      }
      const double furthest = result.furthestBefore ? result.at(*result.furthestBefore).apart : 0;
      if (!result.firstDifference && quantity.apart > furthest) result.furthestBefore = index;
    }
  }
}

std::string quantityText(const Explanation& explanation, const QuantityIndex& index) {
  return fmt::format("{} at {}", explanation.at(index).name, explanation.stages[index.stage].title);
}

std::string differenceText(const Explanation& explanation, const QuantityIndex& index) {
  const Quantity& quantity = explanation.at(index);
  const std::string sides = fmt::format("{} on the device, {} by the reference", valueText(quantity.device),
                                        valueText(quantity.reference));
  const std::string where = fmt::format("{}, {}", explanation.stages[index.stage].title, quantity.name);
  if (quantity.kind == Quantity::Kind::decision) {
    return fmt::format("{}: {}{}", where, sides,
                       quantity.undecidable
                           ? "; replicas of the path differ here, too, so that single precision cannot "
                             "decide it"
                           : "");
  }
  if (quantity.kind == Quantity::Kind::randomNumber)
    return fmt::format("{}: {}; it must be bit-identical", where, sides);
  const double allowed = explanation.replicas > 0 ? quantity.allowed() : kTolerance;
  return fmt::format("{}: {} apart (rounding allows {:.0e}); {}", where, apartText(quantity), allowed, sides);
}

std::string furthestText(const Explanation& explanation) {
  if (!explanation.furthestBefore) return "all numbers are bit-identical";
  const QuantityIndex& index = *explanation.furthestBefore;
  return fmt::format("no number differs by more than {} ({})", apartText(explanation.at(index)),
                     quantityText(explanation, index));
}

}  // namespace

std::string Explanation::verdict() const {
  if (!firstDifference) {
    const bool isGrown = furthestBefore && at(*furthestBefore).apart > kTolerance;
    return fmt::format(
        "The two paths agree: no decision differs, and {}{}.", furthestText(*this),
        isGrown ? fmt::format(", which is rounding, amplified {:.0e} times", at(*furthestBefore).amplification()) : "");
  }
  std::string text = fmt::format("First difference: {}.\nBefore it {}.", differenceText(*this, *firstDifference),
                                 furthestText(*this));
  if (!firstDecision) text += " No decision differs.";
  if (firstDecision && firstDecision != firstDifference) {
    text += fmt::format("\nFirst decision that differs: {}.", differenceText(*this, *firstDecision));
  }
  if (replicas > 0 && !at(*firstDifference).undecidable && at(*firstDifference).kind != Quantity::Kind::randomNumber) {
    text += "\nRounding does not explain it.";
  }
  const Quantity& radiance = stages.back().quantities.back();
  return text +
         fmt::format("\nThe sample's radiance is {}.", radiance.apart == 0 ? "equal" : apartText(radiance) + " apart");
}

void requirePaths(render::Integrator integrator) {
  if (integrator == render::Integrator::path) return;
  throw UsageError(
      "only samples of the path tracer can be explained; for other integrators, a comparison of the tracers "
      "(`candela compare SCENE`) counts the pixels that differ and the decisions at which they diverge");
}

Explanation explainReplays(const scene::Scene& scene, const render::RenderSettings& settings,
                           const render::PixelSample& sample, const render::Replay& device,
                           const render::Replay& reference, std::span<const render::PathTrace> replicas) {
  Explanation result;
  result.scene = scene.name;
  result.sample = sample;
  result.seed = settings.image.seed;
  result.statistics = device.statistics;
  result.device = device.path;
  result.reference = reference.path;
  result.stages = stagesOf(device.path, reference.path, scene);
  result.replicas = static_cast<std::uint32_t>(replicas.size());
  judgeByReplicas(replicas, reference.path, scene, result.stages);
  findDifferences(result);
  return result;
}

Explanation explainSample(const scene::Scene& scene, const render::RenderSettings& settings,
                          const render::PixelSample& sample, render::Renderer& device, render::Renderer& reference) {
  render::RenderSettings replicated = settings;
  replicated.execution.replicas = kReplicaCount;
  const std::unique_ptr<render::Session> session = reference.prepare(scene, replicated);
  return explainReplays(scene, settings, sample, device.replay(scene, settings, sample),
                        session->replayer()->replay(sample),
                        session->replicaSource()->replayReplicas(sample, kReplicaCount));
}

std::optional<Explanation> explainWorst(const scene::Scene& scene, const render::RenderSettings& settings,
                                        const verify::PixelAgreement& pixels, render::Renderer& device,
                                        render::Renderer& reference) {
  if (pixels.equal == pixels.pixels) return std::nullopt;
  render::RenderSettings single = settings;
  single.image.sampleCount = 1;
  return explainSample(scene, single, {pixels.worstX, pixels.worstY, 0}, device, reference);
}

}  // namespace candela::explain
