// Sensors as cameras, and what the film, the sampler and the integrator request.
#pragma once
#include <optional>
#include <vector>

#include "host/formats/loading/load.h"
#include "host/formats/mitsuba/object.h"
#include "host/scene/bounds.h"

namespace candela::mitsuba {

/// Returns the sensor that LoadOptions::camera names by its id or its index, by default the first one; null for "none",
/// and if the scene has none. Throws SceneError for an unknown name.
const Object* chooseSensor(const std::vector<const Object*>& sensors, const scene::LoadOptions& options,
                           const std::string& file);

/// Sets the camera of a scene, and what its film and its sampler request. `bounds`: those of all triangles. Throws
/// PlacedError.
void setSensor(const Object& sensor, const std::optional<scene::Bounds>& bounds, Report& report, scene::Scene& scene);

/// Sets what the integrator requests. Returns its description for a report. Throws PlacedError.
std::string setIntegrator(const Object& integrator, Report& report, scene::Scene& scene);

}  // namespace candela::mitsuba
