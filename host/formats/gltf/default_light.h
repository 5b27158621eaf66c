// The light of files that have none to see the model by.
#pragma once
#include <optional>
#include <string>

#include "host/formats/gltf/cameras.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"

namespace candela::gltf {

/// Adds a background and a directional light from above the left shoulder of the scene's camera, unless the file has
/// lights, enough emission, or an environment replaces them. `bounds` is the box of all triangles. Returns what lights
/// the scene, for a report.
std::string lightUp(scene::Scene& scene, const std::optional<Box>& bounds, const scene::LoadOptions& options);

/// Warns if some light of the scene cannot pass some of its surfaces, although they transmit.
void warnOfShadows(const scene::Scene& scene, scene::DiagnosticLog& log);

}  // namespace candela::gltf
