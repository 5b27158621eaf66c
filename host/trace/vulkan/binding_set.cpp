// Writes descriptor sets, each from its own pool.
#include "host/trace/vulkan/binding_set.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/trace/vulkan/binding_set_impl.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

Usage usageFor(BindingKind kind) {
  switch (kind) {
    case BindingKind::uniformTexelBuffer:
      return Usage::uniformTexel;
    case BindingKind::uniformBuffer:
      return Usage::uniform;
    default:
      return Usage::storage;
  }
}

void requireFit(const std::vector<BindingKind>& kinds, const std::vector<const Buffer*>& buffers) {
  if (kinds.size() != buffers.size()) {
    throw InternalError(fmt::format("{} buffers for a pipeline of {} bindings", buffers.size(), kinds.size()));
  }
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (has(buffers[i]->impl()->usage, usageFor(kinds[i]))) continue;
    throw InternalError(fmt::format("the buffer of binding {} was not created for this use", i));
  }
}

vk::raii::DescriptorPool makePool(const vk::raii::Device& device, const std::vector<BindingKind>& kinds) {
  std::vector<vk::DescriptorPoolSize> sizes;
  for (const BindingKind kind : kinds) sizes.emplace_back(descriptorType(kind), 1);
  return {device, vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes)};
}

void writeBinding(const vk::raii::Device& device, vk::DescriptorSet set, std::uint32_t binding, BindingKind kind,
                  const Buffer::Impl& buffer) {
  const vk::DescriptorBufferInfo range(*buffer.raw.handle, 0, VK_WHOLE_SIZE);
  vk::WriteDescriptorSet write(set, binding, 0, 1, descriptorType(kind));
  if (kind == BindingKind::uniformTexelBuffer) {
    write.pTexelBufferView = &*buffer.texelView;
  } else {
    write.pBufferInfo = &range;
  }
  device.updateDescriptorSets(write, {});
}

}  // namespace

BindingSet::BindingSet(const ComputePipeline& pipeline, const std::vector<const Buffer*>& buffers)
    : impl_(std::make_shared<Impl>()) {
  const std::vector<BindingKind>& kinds = pipeline.impl()->bindings;
  requireFit(kinds, buffers);
  const vk::raii::Device& device = pipeline.impl()->device->handle;
  impl_->pipeline = pipeline.impl();
  guarded("bind buffers", [&] {
    impl_->pool = makePool(device, kinds);
    const vk::DescriptorSetAllocateInfo info(*impl_->pool, *pipeline.impl()->setLayout);
    impl_->handle = std::move(device.allocateDescriptorSets(info).front());
  });
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    writeBinding(device, *impl_->handle, static_cast<std::uint32_t>(i), kinds[i], *buffers[i]->impl());
    impl_->buffers.push_back(buffers[i]->impl());
  }
  pipeline.impl()->device->residents.add(impl_);
}

}  // namespace candela::vulkan
