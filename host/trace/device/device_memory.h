// The memory of a device, and the refusal of scenes that exceed it before anything is allocated.
#pragma once
#include <cstdint>

#include "host/scene/scene.h"
#include "host/trace/render/session.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

/// Returns the bytes of host memory that a render on a device needs besides the device's buffers: the scene, the film
/// of the session and that of the result, and the program with the driver and its compiler.
std::uint64_t hostMemoryNeed(const scene::Scene& scene, const render::RenderSettings& settings);

/// Returns the bytes that buffers may occupy: those of the device, on devices in software at most what `hostBytes`
/// (see hostMemoryNeed) leave of the memory budget.
std::uint64_t usableMemory(const vulkan::DeviceInfo& info, std::uint64_t hostBytes);

/// Returns the predicted peak of the program's memory in bytes for a session on a software device, whose buffers are in
/// host memory; 0 for all other sessions.
std::uint64_t predictedMemory(const render::Session& session);

/// Throws DeviceLimitError if the records of a scene and the buffers of one row of the image exceed that.
void requireDeviceMemory(const vulkan::DeviceInfo& info, std::uint64_t hostBytes, std::uint64_t sceneBytes,
                         std::uint64_t rowBytes);

}  // namespace candela::device
