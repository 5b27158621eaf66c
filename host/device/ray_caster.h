// Traces rays alone on a device: what a benchmark of traversal measures, without paths, shading or film.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "host/device/device_scene.h"
#include "host/flatten/flat_scene.h"
#include "host/vulkan/binding_set.h"
#include "host/vulkan/compute_pipeline.h"
#include "host/vulkan/device.h"
#include "shaders/shared/cast_ray.h"

namespace candela::device {

/// Rays of each kind (kPrimaryRay ...) in the order of pixels along Morton's curve; pixels that have no such ray are
/// left out.
using RaySets = std::array<std::vector<gpu::CastRay>, gpu::kRayKindCount>;

/// One scene in one layout on a device, ready to trace rays through it.
class RayCaster {
 public:
  /// `flat`: made with the same settings. Throws FileError if the device cannot bind the scene, UsageError for a
  /// workgroup that it does not have.
  RayCaster(vulkan::Device& device, flatten::FlatScene flat, const render::RenderSettings& settings);

  /// A primary ray for each pixel, and where it hits something a diffuse ray, and a ray to a light if there are lights.
  /// Throws InternalError if the device stopped a loop.
  RaySets makeRays();

  /// Puts rays on the device in the place of those that were there; `anyHit`: whether something is hit at all before a
  /// ray's limit, else what is hit first, however far.
  void load(std::span<const gpu::CastRay> rays, bool anyHit);
  /// Traces the loaded rays once. Returns the seconds that the device's dispatches took, the first of which, after
  /// load(), includes what a driver compiles.
  double trace();
  /// Of the loaded rays, after trace(). Throws InternalError if the device stopped a loop.
  std::vector<gpu::CastHit> hits() const;

  const flatten::FlatScene& scene() const { return flat_; }
  bool readsTexels() const { return deviceScene_.readsTexels(); }

 private:
  double dispatch(const vulkan::ComputePipeline& pipeline, const vulkan::BindingSet& bindings, std::uint32_t count);

  vulkan::Device& device_;
  render::RenderSettings settings_;
  flatten::FlatScene flat_;
  DeviceScene deviceScene_;
  std::array<vulkan::ComputePipeline, 2> casts_;  ///< closest, any
  vulkan::Buffer unused_;
  vulkan::Buffer rays_;
  vulkan::Buffer hits_;
  std::uint32_t rayCount_ = 0;
  bool anyHit_ = false;
  std::uint32_t chunk_;  ///< rays of one dispatch, so few that it is short
};

}  // namespace candela::device
