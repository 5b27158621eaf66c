// Creates compute pipelines from SPIR-V.
#include "host/trace/vulkan/compute_pipeline.h"

#include <cstddef>

#include "host/trace/vulkan/compute_pipeline_impl.h"
#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/reduced_spirv.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

std::vector<std::uint32_t> withoutConstants(const ShaderCode& code) {
  return code.specialisations.empty() ? code.words : frozenSpirv(code.words, code.specialisations);
}

std::vector<vk::SpecializationMapEntry> entriesOf(const std::vector<Specialisation>& specialisations) {
  std::vector<vk::SpecializationMapEntry> entries;
  for (const Specialisation& one : specialisations) {
    const auto offset = static_cast<std::uint32_t>(entries.size() * sizeof one + offsetof(Specialisation, value));
    entries.emplace_back(one.id, offset, sizeof one.value);
  }
  return entries;
}

}  // namespace

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

ShaderCode codeFor(const Device::Impl& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options) {
  if (options.isFinal) return {{spirv.begin(), spirv.end()}};
  if (device.options.prepareShader) return device.options.prepareShader(spirv, options.specialisations);
  return {reducedSpirv(spirv, options.specialisations)};
}

vk::raii::Pipeline makePipeline(const Device::Impl& device, const vk::raii::PipelineCache& cache,
                                vk::PipelineLayout layout, const ShaderCode& code, const PipelineOptions& options,
                                vk::PipelineCreateFlags flags) {
  const std::span<const std::uint32_t> words(code.words);
  const vk::raii::ShaderModule module(device.handle, vk::ShaderModuleCreateInfo({}, words.size_bytes(), words.data()));
  const std::vector<vk::SpecializationMapEntry> entries = entriesOf(code.specialisations);
  const vk::SpecializationInfo constants(static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         code.specialisations.size() * sizeof(Specialisation),
                                         code.specialisations.data());
  const vk::PipelineShaderStageRequiredSubgroupSizeCreateInfoEXT size(device.options.subgroupSize);
  vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, options.entry.c_str());
  if (device.options.subgroupSize > 0) stage.pNext = &size;
  if (!entries.empty()) stage.pSpecializationInfo = &constants;
  return {device.handle, cache, vk::ComputePipelineCreateInfo(flags, stage, layout)};
}

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
    const ShaderCode code = codeFor(*device.impl(), spirv, options);
    impl_->handle = makePipeline(*device.impl(), device.impl()->pipelineCache, *impl_->layout, code, options);
    if (Recording* const recording = device.impl()->options.recording.get()) {
      impl_->index = static_cast<std::uint32_t>(recording->shaders.size());
      recording->shaders.push_back({withoutConstants(code), options});
    }
  });
  impl_->device->residents.add(impl_);
}

}  // namespace candela::vulkan
