// A flattened scene in device memory.
#pragma once
#include <span>

#include "host/flatten/camera_records.h"
#include "host/flatten/flat_scene.h"
#include "host/vulkan/buffer.h"
#include "host/vulkan/device.h"

namespace candela::device {

/// Whether a device can bind the scene's rows read so; automatic: in one way or the other.
bool canBind(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat, render::SceneLoads loads);

/// How the device is to read the rows, texel or storage: as `settings` ask, or where they do not as their
/// AutomaticChoices say; the other way where the rows do not fit so. Throws FileError, which names both sizes, if the
/// rows exceed what the device can bind.
render::SceneLoads loadsFor(const vulkan::DeviceInfo& info, const flatten::FlatScene& flat,
                            const render::RenderSettings& settings);

/// Buffers that the kernel's scene bindings stand for. The rows are bound twice, as storage and as texels; which of the
/// two the kernel reads is compiled into it, and the other is a single row.
class DeviceScene {
 public:
  /// `loads` as loadsFor() gives them.
  DeviceScene(vulkan::Device& device, const flatten::FlatScene& flat, render::SceneLoads loads);

  /// Replaces what depends on the camera.
  void update(const flatten::CameraRecords& records);

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
