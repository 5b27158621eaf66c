// Scenes of formats that have meshes and materials alone: PLY and OBJ.
#pragma once
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"

namespace candela::scene {

/// Gives a scene the view that frames it, the default light unless it has light enough, and the warnings about both.
/// Returns what a report says about them. Warns of options that have no effect.
FileFacts completeModel(Scene& scene, const LoadOptions& options, DiagnosticLog& log);

/// The material of faces without one: diffuse, with the albedo 0.8; white where vertices have colours.
Material plainMaterial(bool hasColours);

}  // namespace candela::scene
