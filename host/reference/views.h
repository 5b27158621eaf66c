// Pictures of what the camera rays meet: docs/light-transport.md section 10.
#pragma once
#include <optional>

#include "host/reference/pixel_tracer.h"
#include "host/reference/surface.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// Every integrator for which isView() holds.
class ViewTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  ViewTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  void setCamera(const scene::Camera& camera) override;

 private:
  dvec3 radiance(const Ray& ray, SampleNumbers& numbers, Counters& counters, render::PathRecord* record) const override;
  dvec3 valueAt(const Hit& hit, const Surface& surface, SampleNumbers& numbers, Counters& counters,
                render::VertexRecord& record) const;
  /// Whether the ambient occlusion ray of this sample meets nothing.
  bool isOpen(const Surface& surface, SampleNumbers& numbers, Counters& counters, render::VertexRecord& record) const;

  render::Integrator view_;
  std::optional<float> askedAoDistance_;
  double aoDistance_;
};

}  // namespace candela::reference
