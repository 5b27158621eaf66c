// A flattened scene in device memory.
#pragma once
#include <span>

#include "host/trace/flatten/camera_records.h"
#include "host/trace/flatten/flat_scene.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/device.h"

namespace candela::device {

/// Returns whether a device can bind the scene's records with this buffer type; automatic: with at least one of the
/// types.
bool canBind(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat, render::SceneLoads loads);

/// Returns the buffer type through which the device reads the records, texel or storage: the one that `settings`
/// request, or that their AutomaticChoices name (texel if those leave it to the device: see fastestLoads()); if they
/// leave the choice and the records do not fit, the other one.
/// Throws FileError, which names both sizes, if the records exceed what the device can bind.
render::SceneLoads loadsFor(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat,
                            const render::RenderSettings& settings);

/// Buffers for the kernel's scene bindings. The records have two bindings, as storage and as texels. Which of the two
/// the kernel reads is compiled into it; the other one is a single record.
class DeviceScene {
 public:
  /// `loads` is the result of loadsFor().
  DeviceScene(vulkan::Device& device, const flatten::FlatScene& flat, render::SceneLoads loads);

  /// Replaces the records that depend on the camera.
  void update(const flatten::CameraRecords& records);
  /// Replaces the constants alone, such as the seed.
  void updateConstants(const flatten::CameraRecords& records);

  bool readsTexels() const { return readsTexels_; }
  const vulkan::Buffer& rows() const { return rows_; }
  const vulkan::Buffer& texels() const { return texels_; }
  const vulkan::Buffer& uniforms() const { return uniforms_; }

 private:
  void uploadUniforms(const gpu::RenderConstants& constants, std::span<const gpu::uvec4> slotRows);

  bool readsTexels_;
  vulkan::Buffer rows_;
  vulkan::Buffer texels_;
  vulkan::Buffer uniforms_;
};

}  // namespace candela::device
