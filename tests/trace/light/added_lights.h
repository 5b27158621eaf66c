// Point and spot lights that tests add to a scene.
#pragma once
#include <functional>

#include "tests/trace/reference/scene_builder.h"

namespace candela::test {

using AddLight = std::function<void(SceneBuilder&, const vec3&)>;

inline void addPointLight(SceneBuilder& b, const vec3& position) { b.pointLight(position, {1, 2, 3}); }

/// Points down, and illuminates the half space below it.
inline void addSpotLight(SceneBuilder& b, const vec3& position) {
  b.scene.punctualLights.push_back({.kind = scene::PunctualLight::Kind::spot,
                                    .position = position,
                                    .direction = {0, 0, -1},
                                    .intensity = {20, 30, 40},
                                    .versineInner = 0.99f,
                                    .versineOuter = 1});
}

}  // namespace candela::test
