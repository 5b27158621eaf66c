// The device and its limits, which its sessions share.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "host/trace/device/code_form.h"
#include "host/trace/device/pipeline_store.h"
#include "host/trace/vulkan/device.h"

namespace candela::device {

struct DeviceContext {
  vulkan::Device device;
  std::uint32_t
      loopLimit;  ///< loop iterations that the device executes in an invocation: host/trace/vulkan/loop_limit.h
  CodeForm form;
  std::uint64_t maxBandBytes;  ///< maximum size of a band's largest buffer
  PipelineStore pipelines{};
  /// Texel or storage; measured when a session first leaves the choice to the device.
  std::optional<render::SceneLoads> fastestLoads{};
};

}  // namespace candela::device
