// Common part of all integrators: the camera rays of samples, and the scene that they trace.
#pragma once
#include <cstdint>
#include <vector>

#include "host/image/layers.h"
#include "host/scene/scene.h"
#include "host/trace/reference/arithmetic.h"
#include "host/trace/reference/camera.h"
#include "host/trace/reference/ray.h"
#include "host/trace/reference/sampler.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/reference/textured_material.h"
#include "host/trace/reference/tracing.h"
#include "host/trace/render/path_record.h"
#include "host/trace/render/path_trace.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

/// Quantities that the tracer of a sample stores besides its value; null: they are not stored.
struct SampleOutputs {
  render::PathRecord* record = nullptr;  ///< decisions of the path or tree
  image::LayerSample* layers = nullptr;  ///< path tracer only

  SampleOutputs(render::PathRecord* decisions = nullptr, image::LayerSample* layerSample = nullptr)
      : record(decisions), layers(layerSample) {}
};

/// One sample while it is traced.
struct SampleState {
  SampleNumbers& numbers;
  Counters& counters;
  SampleOutputs outputs;
  Arithmetic& arithmetic;
};

/// A scene prepared for rendering by one integrator. Threads share it.
class PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object.
  PixelTracer(const scene::Scene& scene, const render::RenderSettings& settings);
  virtual ~PixelTracer() = default;

  /// Sets the seed and the total number of samples per pixel. Must not be called while samples are traced.
  void setSampling(std::uint32_t seed, std::uint32_t sampleCount);
  /// Moves the camera. Must not be called while samples are traced.
  virtual void setCamera(const scene::Camera& camera);
  /// Sets the image's size for the next call of setCamera().
  void setSize(const render::Extent& size) { image_.size = size; }

  /// Returns the radiance of one sample of a pixel.
  dvec3 sample(std::uint32_t x, std::uint32_t y, std::uint32_t sampleIndex, Counters& counters,
               SampleOutputs outputs) const;
  /// Returns the same as another arithmetic computes it. `cache`, unless null, has the random numbers of this sample.
  dvec3 sample(const render::PixelSample& sample, Counters& counters, SampleOutputs outputs, Arithmetic& arithmetic,
               NumberCache* cache) const;
  const scene::Scene& scene() const { return scene_; }
  const Tracing& tracing() const { return tracing_; }
  std::uint32_t seed() const { return image_.seed; }

 protected:
  /// Integrators obtain materials only from this function, which depends only on the surface point.
  SurfaceMaterial materialAt(const Surface& surface, Arithmetic& arithmetic) const {
    SurfaceMaterial material = materials_[surface.material];
    if (variesOverTriangles_) applyTextures({scene_, arithmetic}, surface, material);
    return material;
  }
  /// Sets the numbers with which the textures of a path's vertex are looked up. `vertex` counts from 1.
  void jitterTextures(Surface& surface, SampleNumbers& numbers, std::uint32_t vertex) const;
  /// Ray::opacityKey of the ray that ends at a path's vertex, or of the shadow ray from there. `vertex` counts from 1.
  std::uint32_t opacityKeyOf(const SampleNumbers& numbers, std::uint32_t vertex, bool isShadowRay) const;
  SampleNumbers numbersOf(const render::PixelSample& sample, NumberCache* cache = nullptr) const {
    return SampleNumbers(sampler_, sample.x, sample.y, sample.index, cache);
  }
  Ray cameraRay(const render::PixelSample& sample, SampleNumbers& numbers, Arithmetic& arithmetic) const {
    return arithmetic.cameraRay(camera_.generate(sample.x, sample.y, numbers), originVaries_);
  }

 private:
  /// Returns the integrator's value of a sample whose camera ray is `ray`.
  virtual dvec3 radiance(const Ray& ray, SampleState& state) const = 0;

  const scene::Scene& scene_;
  render::ImageSettings image_;
  Sampler sampler_;
  CameraRays camera_;
  bool originVaries_;         ///< camera rays start at different points
  bool variesOverTriangles_;  ///< some material has textures, or some mesh vertex colours
  bool isTransparent_;        ///< some material has an opacity
  Tracing tracing_;
  std::vector<SurfaceMaterial> materials_;
};

}  // namespace candela::reference
