// Creates compute pipelines from SPIR-V.
#include "host/vulkan/compute_pipeline.h"

#include "host/vulkan/compute_pipeline_impl.h"
#include "host/vulkan/device.h"
#include "host/vulkan/reduced_spirv.h"
#include "host/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

vk::raii::DescriptorSetLayout makeSetLayout(const vk::raii::Device& device, const std::vector<BindingKind>& kinds) {
  std::vector<vk::DescriptorSetLayoutBinding> bindings;
  for (const BindingKind kind : kinds) {
    const auto binding = static_cast<std::uint32_t>(bindings.size());
    bindings.emplace_back(binding, descriptorType(kind), 1, vk::ShaderStageFlagBits::eCompute);
  }
  return {device, vk::DescriptorSetLayoutCreateInfo({}, bindings)};
}

vk::raii::PipelineLayout makeLayout(const vk::raii::Device& device, vk::DescriptorSetLayout setLayout,
                                    std::uint32_t pushConstantBytes) {
  const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, pushConstantBytes);
  vk::PipelineLayoutCreateInfo info({}, setLayout);
  if (pushConstantBytes > 0) info.setPushConstantRanges(range);
  return {device, info};
}

vk::raii::Pipeline makePipeline(const Device::Impl& device, vk::PipelineLayout layout,
                                std::span<const std::uint32_t> code, const PipelineOptions& options) {
  const vk::raii::ShaderModule module(device.handle, vk::ShaderModuleCreateInfo({}, code.size_bytes(), code.data()));
  const vk::PipelineShaderStageRequiredSubgroupSizeCreateInfoEXT size(device.options.subgroupSize);
  vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, options.entry.c_str());
  if (device.options.subgroupSize > 0) stage.pNext = &size;
  return {device.handle, device.pipelineCache, vk::ComputePipelineCreateInfo({}, stage, layout)};
}

}  // namespace

vk::DescriptorType descriptorType(BindingKind kind) {
  switch (kind) {
    case BindingKind::uniformTexelBuffer:
      return vk::DescriptorType::eUniformTexelBuffer;
    case BindingKind::uniformBuffer:
      return vk::DescriptorType::eUniformBuffer;
    default:
      return vk::DescriptorType::eStorageBuffer;
  }
}

ComputePipeline::ComputePipeline(Device& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options)
    : impl_(std::make_shared<Impl>()) {
  impl_->device = device.impl();
  impl_->bindings = options.bindings;
  impl_->pushConstantBytes = options.pushConstantBytes;
  guarded("create a compute pipeline", [&] {
    const vk::raii::Device& handle = device.impl()->handle;
    impl_->setLayout = makeSetLayout(handle, options.bindings);
    impl_->layout = makeLayout(handle, *impl_->setLayout, options.pushConstantBytes);
    const std::vector<std::uint32_t> code = options.isFinal ? std::vector(spirv.begin(), spirv.end())
                                                            : reducedSpirv(spirv, options.specialisations);
    impl_->handle = makePipeline(*device.impl(), *impl_->layout, code, options);
    if (Recording* const recording = device.impl()->options.recording.get()) {
      impl_->index = static_cast<std::uint32_t>(recording->shaders.size());
      recording->shaders.push_back({code, options});
    }
  });
  impl_->device->residents.add(impl_);
}

}  // namespace candela::vulkan
