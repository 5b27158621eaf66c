// The effect that rounding may have on the quantities of a path: the spread of replicas of the reference's path.
#pragma once
#include <span>
#include <vector>

#include "host/judge/explain/stages.h"
#include "host/scene/scene.h"
#include "host/trace/render/path_trace.h"

namespace candela::explain {

/// Number of replicas that are compared with the exact path.
inline constexpr std::uint32_t kReplicaCount = 16;

/// Sets the spread of every quantity of `stages`, and which decisions replicas take differently; differences are then
/// judged by Quantity::allowed(). Without replicas nothing changes.
void judgeByReplicas(std::span<const render::PathTrace> replicas, const render::PathTrace& reference,
                     const scene::Scene& scene, std::vector<Stage>& stages);

}  // namespace candela::explain
