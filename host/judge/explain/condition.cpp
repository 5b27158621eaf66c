// Compares replicas with the exact path, by the same quantities as the device.
#include "host/judge/explain/condition.h"

#include <algorithm>

namespace candela::explain {
namespace {

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

}  // namespace

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

}  // namespace candela::explain
