// Traces rays through the BVH layouts of a device.
#pragma once
#include <memory>

#include "host/measure/bench/measure_rays.h"

namespace candela::bench {

/// A scene on a device in one layout.
class DeviceTracer : public RayTracer {
 public:
  /// Takes the arguments of RayCaster's constructor.
  DeviceTracer(vulkan::Device& device, const flatten::FlatScene& flat, const render::RenderSettings& settings);

  device::RaySets makeRays() { return caster_.makeRays(); }
  void load(std::span<const gpu::CastRay> rays, bool anyHit) override { caster_.load(rays, anyHit); }
  double trace() override { return caster_.trace(); }
  std::vector<gpu::CastHit> hits() override { return caster_.hits(); }
  bool needsWarmUp() const override { return onGpu_; }

  render::LayoutInUse layout() const;  ///< list: all primitives are tested
  render::SceneLoads sceneLoads() const {
    return caster_.readsTexels() ? render::SceneLoads::texel : render::SceneLoads::storage;
  }
  std::uint64_t sceneBytes() const { return caster_.sceneBytes(); }

 private:
  bool onGpu_;
  device::RayCaster caster_;
};

/// Returns a tracer for each combination of layout and load type that the device can bind, or only for those that
/// `settings` select. Throws FileError if the device can bind none.
std::vector<std::unique_ptr<DeviceTracer>> deviceTracers(vulkan::Device& device, const scene::Scene& scene,
                                                         const render::RenderSettings& settings);

}  // namespace candela::bench
