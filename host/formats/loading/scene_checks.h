// Checks that need the complete scene.
#pragma once
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// True if something emits, a light shines, or the background is not black.
bool hasLight(const Scene& scene);

/// Warns about a scene without objects, and about one without light to which `options` add no environment.
void checkScene(const Scene& scene, const LoadOptions& options, DiagnosticLog& log);

}  // namespace candela::scene
