// The light of files that have none to see the model by.
#pragma once
#include <optional>
#include <string>

#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/load.h"
#include "host/scene/bounds.h"

namespace candela::scene {

/// The light that a file needs besides its own.
struct DefaultLight {
  std::optional<PunctualLight> light{};  ///< comes with a background; empty: the file's own light is enough
  std::string ownLight;                  ///< describes the light of the file, for a report
};

/// Returns a directional light from above the left shoulder of the scene's camera, unless the scene has lights or
/// enough emission. `bounds` is the box of all triangles.
DefaultLight defaultLightOf(const Scene& scene, const std::optional<Bounds>& bounds);

/// Adds the default light and its background, unless an environment replaces them. Returns what lights the scene, for a
/// report.
std::string lightUp(Scene& scene, const DefaultLight& light, const LoadOptions& options);

/// Sets the reach of all punctual lights to half the diagonal of `bounds`.
void setReach(const std::optional<Bounds>& bounds, Scene& scene);

/// Warns if some light of the scene cannot pass some of its surfaces, although they transmit.
void warnOfShadows(const Scene& scene, DiagnosticLog& log);

}  // namespace candela::scene
