// What all integrators share: a camera ray for each sample of each pixel, and what it is traced through.
#pragma once
#include <cstdint>
#include <vector>

#include "host/reference/camera.h"
#include "host/reference/ray.h"
#include "host/reference/sampler.h"
#include "host/reference/surface.h"
#include "host/reference/surface_material.h"
#include "host/reference/tracing.h"
#include "host/render/path_record.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

/// A scene made ready to be rendered by one integrator. Threads share it.
class PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  PixelTracer(const scene::Scene& scene, const render::RenderSettings& settings);
  virtual ~PixelTracer() = default;

  /// Other random numbers for the samples to come.
  void setSeed(std::uint32_t seed);
  /// Moves the eye. Not while samples are traced.
  virtual void setCamera(const scene::Camera& camera);

  /// The radiance that one sample of a pixel sees. `record`, unless null, takes what its path or tree decided.
  dvec3 sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
               render::PathRecord* record) const;
  const Tracing& tracing() const { return tracing_; }

 protected:
  const scene::Scene& scene() const { return scene_; }
  /// All that an integrator knows of a material comes from here, and the surface point is all that it depends on.
  const SurfaceMaterial& materialAt(const Surface& surface) const { return materials_[surface.material]; }
  SampleNumbers numbersOf(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex) const {
    return SampleNumbers(sampler_, x, y, sampleIndex);
  }
  Ray cameraRay(std::uint32_t x, std::uint32_t y, SampleNumbers& numbers) const {
    return camera_.generate(x, y, numbers);
  }

 private:
  /// What the integrator makes of a sample whose camera ray is `ray`.
  virtual dvec3 radiance(const Ray& ray, SampleNumbers& numbers, Counters& counters,
                         render::PathRecord* record) const = 0;

  const scene::Scene& scene_;
  render::ImageSettings image_;
  Sampler sampler_;
  CameraRays camera_;
  Tracing tracing_;
  std::vector<SurfaceMaterial> materials_;
};

}  // namespace candela::reference
