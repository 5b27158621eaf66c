// What can only be said of a scene once all of it has been read.
#pragma once
#include "host/scene/diagnostic_log.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Warns of a scene without objects or without light.
void checkScene(const Scene& scene, DiagnosticLog& log);

}  // namespace candela::scene
