// The Vulkan commands behind a CommandRecorder.
#pragma once
#include "host/vulkan/command_recorder.h"
#include "host/vulkan/device_impl.h"

namespace candela::vulkan {

struct CommandRecorder::Impl {
  Device::Impl& device;

  /// Makes what earlier commands wrote, in this submission and before it, visible to the next. Before every command.
  void makeVisibleToNext() const;
  /// Makes what the commands wrote visible to the host. After the last.
  void makeVisibleToHost() const;
  void copy(vk::Buffer from, std::uint64_t fromOffset, vk::Buffer to, std::uint64_t toOffset,
            std::uint64_t bytes) const;
};

}  // namespace candela::vulkan
