// The views, pictures of properties of the surfaces that camera rays hit: docs/light-transport.md section 10.
#pragma once
#include <optional>

#include "host/scene/scene.h"
#include "host/trace/reference/pixel_tracer.h"
#include "host/trace/reference/surface.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

/// Tracer for every integrator for which isView() is true.
class ViewTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  ViewTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  void setCamera(const scene::Camera& camera) override;

 private:
  dvec3 radiance(const Ray& ray, SampleState& state) const override;
  dvec3 valueAt(const Hit& hit, const Surface& surface, SampleState& state, render::VertexRecord& record) const;
  /// Returns whether the ambient occlusion ray of this sample hits nothing.
  bool isOpen(const Surface& surface, SampleState& state, render::VertexRecord& record) const;

  render::Integrator view_;
  std::optional<float> askedAoDistance_;
  double aoDistance_;
};

}  // namespace candela::reference
