// The form of the code that a device gets, which depends on what the device is. No form changes a bit of an image.
#pragma once
#include <cstdint>

#include "host/trace/flatten/small_scene.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device_info.h"
#include "host/trace/vulkan/loads_probe.h"

namespace candela::device {

struct CodeForm {
  /// The device is a processor: it executes the invocations of a subgroup as lanes of its vector registers, both sides
  /// of every branch under masks, and branches of loops only at their ends. docs/driver-workarounds.md, sections 3, 7,
  /// 8 and 16.
  bool masksLanes = true;
  /// The device may stop loops silently, so that kernels count the loops that it stopped: section 4.
  bool limitsLoops = true;
};

/// `loopLimit` is the result of vulkan::probeLoopLimit().
CodeForm codeFormOf(const vulkan::DeviceInfo& info, std::uint32_t loopLimit);

/// Returns the buffer type with which renders are faster. Devices in software are measured; with others, both types
/// were equally fast where they were compared, and texels are chosen.
render::SceneLoads fastestLoads(vulkan::Device& device);
/// Returns storage if it takes at most 1.25 times as long as texels in the probe, else texels:
/// docs/driver-workarounds.md section 9.
render::SceneLoads fasterLoads(const vulkan::LoadTimes& times);

/// Returns the rule for a device: on processors with wide vectors, one load serves all lanes, and lists are long; on
/// those with vectors of four lanes, there are none, because the drivers in question compile every copy of an unrolled
/// test (SwiftShader takes minutes for eight spheres); elsewhere, lists cost what sixteen triangles do.
flatten::SmallSceneRule smallSceneRule(const vulkan::DeviceInfo& info);

}  // namespace candela::device
