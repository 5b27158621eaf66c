// Checks that need the complete scene.
#pragma once
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"
#include "host/scene/bounds.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// True if something emits, a light shines, or the background is not black.
bool hasLight(const Scene& scene);

/// Warns about a scene without objects, and about one without light to which `options` add no environment.
void checkScene(const Scene& scene, const LoadOptions& options, DiagnosticLog& log);

/// Warns about a model without extent, and about one that is so small for its distance from the origin that single
/// precision shows steps. `bounds`: those of the model.
void warnOfExtent(const std::optional<Bounds>& bounds, DiagnosticLog& log);

}  // namespace candela::scene
