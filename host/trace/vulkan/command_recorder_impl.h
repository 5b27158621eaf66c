// The Vulkan command buffer of a CommandRecorder.
#pragma once
#include <memory>
#include <vector>

#include "host/trace/vulkan/command_recorder.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device_impl.h"

namespace candela::vulkan {

struct CommandRecorder::Impl {
  Device::Impl& device;
  const vk::raii::CommandBuffer& commands;
  /// The recorded pipelines that have not run before. A pipeline may occur several times.
  mutable std::vector<std::shared_ptr<ComputePipeline::Impl>> newPipelines{};

  /// Makes the writes of earlier commands, in this submission and before it, visible to the next. Called before every
  /// command.
  void makeVisibleToNext() const;
  /// Makes the writes of the commands visible to the host. Called after the last command.
  void makeVisibleToHost() const;
  void copy(vk::Buffer from, std::uint64_t fromOffset, vk::Buffer to, std::uint64_t toOffset,
            std::uint64_t bytes) const;
};

}  // namespace candela::vulkan
