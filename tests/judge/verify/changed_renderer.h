// One side of a comparison that renders a changed scene: a planted difference.
#pragma once
#include <memory>

#include "host/trace/render/renderer.h"

namespace candela::verify {

/// Renders `scene` instead of the scene that it is given. The arguments must outlive the object.
class ChangedRenderer : public render::Renderer {
 public:
  ChangedRenderer(render::Renderer& renderer, const scene::Scene& scene) : renderer_(renderer), scene_(scene) {}
  std::unique_ptr<render::Session> prepare(const scene::Scene&, const render::RenderSettings& settings) override {
    return renderer_.prepare(scene_, settings);
  }

 private:
  render::Renderer& renderer_;
  const scene::Scene& scene_;
};

}  // namespace candela::verify
