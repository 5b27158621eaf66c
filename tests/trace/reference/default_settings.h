// Settings of renders in tests.
#pragma once
#include "host/trace/render/request.h"

namespace candela::render {

/// Returns settings that depend on no scene: the defaults, and a size of 0 x 0 pixels, which tests replace.
inline RenderSettings defaultSettings() {
  scene::Scene scene;
  scene.camera.emplace();
  RenderRequest request;
  request.size = Extent{};
  request.accel = AccelKind::bvh;
  return resolve(request, scene);
}

}  // namespace candela::render
