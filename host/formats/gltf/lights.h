// KHR_lights_punctual.
#pragma once
#include "host/formats/gltf/value.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/scene/scene.h"

namespace candela::gltf {

/// A light of the extension at a node. Candela and lux are taken as W/sr and W/m^2, without the factor 683; `range` is
/// ignored. Warns of cones with a hard edge. Throws JsonError.
scene::PunctualLight punctualLight(const Value& light, const glm::dmat4& world, scene::DiagnosticLog& log);

}  // namespace candela::gltf
