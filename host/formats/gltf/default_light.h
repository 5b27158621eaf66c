// The light of files that have none to see the model by.
#pragma once
#include <optional>
#include <string>

#include "host/formats/gltf/cameras.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"

namespace candela::gltf {

/// The light that a file needs besides its own.
struct DefaultLight {
  std::optional<scene::PunctualLight> light{};  ///< comes with a background; empty: the file's own light is enough
  std::string ownLight;                         ///< describes the light of the file, for a report
};

/// Returns a directional light from above the left shoulder of the scene's camera, unless the scene has lights or
/// enough emission. `bounds` is the box of all triangles.
DefaultLight defaultLightOf(const scene::Scene& scene, const std::optional<Box>& bounds);

/// Adds the default light and its background, unless an environment replaces them. Returns what lights the scene, for a
/// report.
std::string lightUp(scene::Scene& scene, const DefaultLight& light, const scene::LoadOptions& options);

/// Warns if some light of the scene cannot pass some of its surfaces, although they transmit.
void warnOfShadows(const scene::Scene& scene, scene::DiagnosticLog& log);

}  // namespace candela::gltf
