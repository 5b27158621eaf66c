// The stages of a path, camera and vertices, each with its quantities in the order in which the estimator computes
// them.
#pragma once
#include <string>
#include <vector>

#include "host/judge/explain/quantity.h"
#include "host/scene/scene.h"
#include "host/trace/render/path_trace.h"

namespace candela::explain {

struct Stage {
  std::string title;  ///< "camera", "vertex 3" or "sample"
  std::vector<Quantity> quantities;
};

/// Returns one stage for the camera, one for each vertex that either side has recorded, and one for the sample's
/// radiance. `scene` provides names for indices.
std::vector<Stage> stagesOf(const render::PathTrace& device, const render::PathTrace& reference,
                            const scene::Scene& scene);

}  // namespace candela::explain
