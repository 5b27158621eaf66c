// Records dispatches, fills and copies with the barriers between them.
#include "host/trace/vulkan/command_recorder.h"

#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/trace/vulkan/binding_set_impl.h"
#include "host/trace/vulkan/buffer_impl.h"
#include "host/trace/vulkan/command_recorder_impl.h"
#include "host/trace/vulkan/compute_pipeline_impl.h"

namespace candela::vulkan {
namespace {

using Access = vk::AccessFlagBits;
using Stage = vk::PipelineStageFlagBits;

constexpr vk::PipelineStageFlags kDeviceStages = Stage::eDrawIndirect | Stage::eComputeShader | Stage::eTransfer;
constexpr vk::AccessFlags kWrites = Access::eShaderWrite | Access::eTransferWrite;
constexpr vk::AccessFlags kReads = Access::eShaderRead | Access::eUniformRead | Access::eTransferRead |
                                   Access::eIndirectCommandRead;

void requireGroups(const vk::PhysicalDeviceLimits& limits, GroupCount groups) {
  const auto& max = limits.maxComputeWorkGroupCount;
  const bool isNone = groups.x == 0 || groups.y == 0 || groups.z == 0;
  if (!isNone && groups.x <= max[0] && groups.y <= max[1] && groups.z <= max[2]) return;
  throw InternalError(fmt::format("a dispatch of {} x {} x {} workgroups exceeds the limit of {} x {} x {}", groups.x,
                                  groups.y, groups.z, max[0], max[1], max[2]));
}

RecordedDispatch recordedDispatch(const ComputePipeline& pipeline, const BindingSet& bindings,
                                  std::span<const std::byte> pushConstants, GroupCount groups) {
  RecordedDispatch dispatch{pipeline.impl()->index, {}, {pushConstants.begin(), pushConstants.end()}, groups, {}};
  for (const auto& buffer : bindings.impl()->buffers) dispatch.buffers.push_back(buffer->index);
  return dispatch;
}

}  // namespace

void CommandRecorder::Impl::makeVisibleToNext() const {
  const vk::MemoryBarrier barrier(kWrites, kReads | kWrites);
  commands.pipelineBarrier(kDeviceStages, kDeviceStages, {}, barrier, {}, {});
}

void CommandRecorder::Impl::makeVisibleToHost() const {
  const vk::MemoryBarrier barrier(kWrites, Access::eHostRead);
  commands.pipelineBarrier(kDeviceStages, Stage::eHost, {}, barrier, {}, {});
}

void CommandRecorder::Impl::copy(vk::Buffer from, std::uint64_t fromOffset, vk::Buffer to, std::uint64_t toOffset,
                                 std::uint64_t bytes) const {
  makeVisibleToNext();
  commands.copyBuffer(from, to, vk::BufferCopy(fromOffset, toOffset, bytes));
}

void CommandRecorder::prepareDispatch(const ComputePipeline& pipeline, const BindingSet& bindings,
                                      std::span<const std::byte> pushConstants) {
  const ComputePipeline::Impl& shader = *pipeline.impl();
  if (pushConstants.size() != shader.pushConstantBytes) {
    throw InternalError(fmt::format("{} bytes of push constants for a pipeline created with {}", pushConstants.size(),
                                    shader.pushConstantBytes));
  }
  if (!shader.hasRun) impl_.newPipelines.push_back(pipeline.impl());
  const vk::raii::CommandBuffer& commands = impl_.commands;
  impl_.makeVisibleToNext();
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, *shader.handle);
  commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *shader.layout, 0, *bindings.impl()->handle, {});
  if (pushConstants.empty()) return;
  const vk::ArrayProxy<const std::byte> bytes(static_cast<std::uint32_t>(pushConstants.size()), pushConstants.data());
  commands.pushConstants<std::byte>(*shader.layout, vk::ShaderStageFlagBits::eCompute, 0, bytes);
}

void CommandRecorder::dispatch(const ComputePipeline& pipeline, const BindingSet& bindings,
                               std::span<const std::byte> pushConstants, GroupCount groups) {
  requireGroups(impl_.device.limits, groups);
  impl_.device.note([&] { return recordedDispatch(pipeline, bindings, pushConstants, groups); });
  prepareDispatch(pipeline, bindings, pushConstants);
  impl_.commands.dispatch(groups.x, groups.y, groups.z);
}

void CommandRecorder::dispatchIndirect(const ComputePipeline& pipeline, const BindingSet& bindings,
                                       std::span<const std::byte> pushConstants, const Buffer& groups,
                                       std::uint64_t offset) {
  groups.impl()->requireRange(offset, sizeof(vk::DispatchIndirectCommand));
  impl_.device.note([&] {
    RecordedDispatch dispatch = recordedDispatch(pipeline, bindings, pushConstants, {});
    dispatch.indirect = {groups.impl()->index, offset};
    return dispatch;
  });
  prepareDispatch(pipeline, bindings, pushConstants);
  impl_.commands.dispatchIndirect(*groups.impl()->raw.handle, offset);
}

void CommandRecorder::updateBuffer(const Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data) {
  buffer.impl()->requireRange(offset, data.size());
  if (data.empty()) return;
  impl_.device.note([&] { return RecordedWrite{buffer.impl()->index, offset, {data.begin(), data.end()}}; });
  impl_.makeVisibleToNext();
  const vk::ArrayProxy<const std::byte> bytes(static_cast<std::uint32_t>(data.size()), data.data());
  impl_.commands.updateBuffer<std::byte>(*buffer.impl()->raw.handle, offset, bytes);
}

void CommandRecorder::fillBuffer(const Buffer& buffer, std::uint32_t word, std::uint64_t offset, std::uint64_t bytes) {
  buffer.impl()->requireRange(offset, bytes);
  if (bytes == 0) return;
  impl_.device.note([&] { return RecordedFill{buffer.impl()->index, offset, bytes, word}; });
  impl_.makeVisibleToNext();
  impl_.commands.fillBuffer(*buffer.impl()->raw.handle, offset, bytes, word);
}

void CommandRecorder::fillBuffer(const Buffer& buffer, std::uint32_t word) {
  fillBuffer(buffer, word, 0, buffer.bytes());
}

void CommandRecorder::copyBuffer(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
                                 std::uint64_t bytes) {
  from.impl()->requireRange(fromOffset, bytes);
  to.impl()->requireRange(toOffset, bytes);
  if (bytes == 0) return;
  impl_.device.note([&] { return RecordedCopy{from.impl()->index, fromOffset, to.impl()->index, toOffset, bytes}; });
  impl_.copy(*from.impl()->raw.handle, fromOffset, *to.impl()->raw.handle, toOffset, bytes);
}

}  // namespace candela::vulkan
