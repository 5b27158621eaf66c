// What all sessions on a device share.
#pragma once
#include <cstdint>
#include <memory>

#include "host/device/pipeline_store.h"
#include "host/vulkan/device.h"

namespace candela::device {

struct DeviceContext {
  vulkan::Device device;
  std::uint32_t loopLimit;     ///< loop iterations that the device grants an invocation: host/vulkan/loop_limit.h
  std::uint64_t maxBandBytes;  ///< of the largest of a band's buffers
  PipelineStore pipelines{};
};

}  // namespace candela::device
