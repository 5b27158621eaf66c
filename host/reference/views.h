// Pictures of what the camera rays meet: docs/light-transport.md section 10.
#pragma once
#include <vector>

#include "host/reference/bsdf.h"
#include "host/reference/camera.h"
#include "host/reference/pixel_tracer.h"
#include "host/reference/sampler.h"
#include "host/reference/surface.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// Every integrator for which isView() holds.
class ViewTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  ViewTracer(const Scene& scene, const RenderSettings& settings);

  dvec3 sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
               PathRecord* record) const override;
  const Tracing& tracing() const override { return tracing_; }

 private:
  dvec3 valueAt(const Hit& hit, const Surface& surface, SampleNumbers& numbers, Counters& counters,
                VertexRecord& record) const;
  /// Whether the ambient occlusion ray of this sample meets nothing.
  bool isOpen(const Surface& surface, SampleNumbers& numbers, Counters& counters, VertexRecord& record) const;

  const Scene& scene_;
  Integrator view_;
  double aoDistance_;
  Sampler sampler_;
  CameraRays camera_;
  Tracing tracing_;
  std::vector<Bsdf> bsdfs_;  ///< by material
};

}  // namespace candela::reference
