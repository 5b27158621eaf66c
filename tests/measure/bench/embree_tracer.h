// Embree 3 as a tracer of a benchmark's rays.
#pragma once
#include <embree3/rtcore.h>

#include <array>
#include <vector>

#include "host/measure/bench/measure_rays.h"
#include "host/scene/scene.h"

namespace candela::bench {

/// rtcIntersect1 and rtcOccluded1 on all cores, over a scene's triangles and spheres. A closest hit has the distance
/// and the primitive's index in the scene.
class EmbreeTracer : public RayTracer {
 public:
  /// Throws FileError if the scene has other primitives, or no Embree device can be created.
  explicit EmbreeTracer(const scene::Scene& scene);
  ~EmbreeTracer() override;
  EmbreeTracer(const EmbreeTracer&) = delete;
  EmbreeTracer& operator=(const EmbreeTracer&) = delete;

  void load(std::span<const gpu::CastRay> rays, bool anyHit) override;
  double trace() override;
  std::vector<gpu::CastHit> hits() override { return hits_; }
  bool isExact() const override { return false; }

  gpu::CastHit closest(const gpu::CastRay& ray) const;
  gpu::CastHit any(const gpu::CastRay& ray) const;

 private:
  void addTriangles(const scene::Scene& scene);
  void addSpheres(const scene::Scene& scene);
  void traceRange(std::size_t first, std::size_t end);

  RTCDevice device_;
  RTCScene scene_;
  std::array<std::vector<std::uint32_t>, 2> indices_;  ///< primitive indices of the scene, by geometry
  std::vector<gpu::CastRay> rays_;
  std::vector<gpu::CastHit> hits_;
  bool anyHit_ = false;
};

}  // namespace candela::bench
