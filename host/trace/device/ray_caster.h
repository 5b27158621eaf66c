// Traces given rays on a device, for benchmarks of traversal without paths, shading and film.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "host/trace/device/code_form.h"
#include "host/trace/device/device_scene.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"
#include "shaders/shared/cast_ray.h"

namespace candela::device {

/// Rays of each kind (kPrimaryRay ...) in the order of pixels along Morton's curve. Pixels without such a ray are
/// omitted.
using RaySets = std::array<std::vector<gpu::CastRay>, gpu::kRayKindCount>;

/// One scene in one layout on a device, ready to trace rays through it.
class RayCaster {
 public:
  /// `flat` must have been made with the same settings. Throws FileError if the device cannot bind the scene,
  /// UsageError if it does not support the workgroup.
  RayCaster(vulkan::Device& device, const flatten::FlatScene& flat, const render::RenderSettings& settings);

  /// Returns a primary ray for each pixel; if it hits something, also a diffuse ray, and a ray to a light if there are
  /// lights. Throws InternalError if the device stopped a loop.
  RaySets makeRays();

  /// Replaces the rays on the device. `anyHit`: only whether the ray hits anything before its maximum distance is
  /// computed; otherwise the closest hit, at any distance.
  void load(std::span<const gpu::CastRay> rays, bool anyHit);
  /// Traces the loaded rays once. Returns the duration of the device's dispatches in seconds. The first one after
  /// load() includes the driver's compilation.
  double trace();
  /// Returns the hits of the loaded rays, after trace(). Throws InternalError if the device stopped a loop.
  std::vector<gpu::CastHit> hits() const;

  const flatten::SceneShape& shape() const { return shape_; }
  std::uint64_t sceneBytes() const { return sceneBytes_; }  ///< of the scene's records
  bool readsTexels() const { return deviceScene_.readsTexels(); }

 private:
  double dispatch(const vulkan::ComputePipeline& pipeline, const vulkan::BindingSet& bindings, std::uint32_t count);

  vulkan::Device& device_;
  render::RenderSettings settings_;
  CodeForm form_;
  flatten::SceneShape shape_;
  std::uint64_t sceneBytes_;
  DeviceScene deviceScene_;
  std::array<vulkan::ComputePipeline, 2> casts_;  ///< closest hit, any hit
  vulkan::Buffer unused_;
  vulkan::Buffer rays_;
  vulkan::Buffer hits_;
  std::uint32_t rayCount_ = 0;
  bool anyHit_ = false;
  std::uint32_t chunk_;  ///< rays of one dispatch, few enough that it is short
};

}  // namespace candela::device
