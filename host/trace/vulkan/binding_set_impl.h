// The Vulkan handles of a BindingSet.
#pragma once
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer_impl.h"
#include "host/trace/vulkan/compute_pipeline_impl.h"

namespace candela::vulkan {

struct BindingSet::Impl {
  std::shared_ptr<ComputePipeline::Impl> pipeline;
  std::vector<std::shared_ptr<Buffer::Impl>> buffers;
  vk::raii::DescriptorPool pool{nullptr};
  vk::raii::DescriptorSet handle{nullptr};
};

}  // namespace candela::vulkan
