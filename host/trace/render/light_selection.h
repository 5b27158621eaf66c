// How the lights of a scene are chosen by default.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/render/settings.h"

namespace candela::render {

/// The least number of lights for which a tree is worth its time. docs/performance-journal.md, "Many lights", has the
/// measurements.
inline constexpr std::size_t kMinTreeLights = 24;

/// Returns `tree` for scenes with at least kMinTreeLights emissive triangles, emissive spheres, point and spot lights,
/// unless all of them are so far from everything else that they are about equally important wherever their light
/// arrives.
LightSelection selectionFor(const scene::Scene& scene);

}  // namespace candela::render
