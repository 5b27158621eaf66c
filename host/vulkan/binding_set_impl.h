// The Vulkan handles of a BindingSet.
#pragma once
#include "host/vulkan/binding_set.h"
#include "host/vulkan/buffer_impl.h"
#include "host/vulkan/compute_pipeline_impl.h"

namespace candela::vulkan {

struct BindingSet::Impl {
  std::shared_ptr<ComputePipeline::Impl> pipeline;
  std::vector<std::shared_ptr<Buffer::Impl>> buffers;
  vk::raii::DescriptorPool pool{nullptr};
  vk::raii::DescriptorSet handle{nullptr};
};

}  // namespace candela::vulkan
