// The Vulkan handles of a ComputePipeline.
#pragma once
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device_impl.h"

namespace candela::vulkan {

struct ComputePipeline::Impl {
  std::shared_ptr<Device::Impl> device;
  std::vector<BindingKind> bindings;
  std::uint32_t pushConstantBytes = 0;
  bool hasRun = false;      ///< a run with this pipeline has ended, so that the driver has compiled it
  std::uint32_t index = 0;  ///< in Recording::shaders, if the device has a recording
  vk::raii::DescriptorSetLayout setLayout{nullptr};
  vk::raii::PipelineLayout layout{nullptr};
  vk::raii::Pipeline handle{nullptr};
};

vk::DescriptorType descriptorType(BindingKind kind);

vk::raii::DescriptorSetLayout makeSetLayout(const vk::raii::Device& device, const std::vector<BindingKind>& kinds);
vk::raii::PipelineLayout makeLayout(const vk::raii::Device& device, vk::DescriptorSetLayout setLayout,
                                    std::uint32_t pushConstantBytes);
/// Returns the code that the driver gets.
ShaderCode codeFor(const Device::Impl& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options);
vk::raii::Pipeline makePipeline(const Device::Impl& device, const vk::raii::PipelineCache& cache,
                                vk::PipelineLayout layout, const ShaderCode& code, const PipelineOptions& options,
                                vk::PipelineCreateFlags flags = {});

}  // namespace candela::vulkan
