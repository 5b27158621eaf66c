// Buffers: limits, views, and transfers to and from device memory.
#include "host/trace/vulkan/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "host/base/errors.h"
#include "host/trace/vulkan/buffer_impl.h"
#include "host/trace/vulkan/command_recorder_impl.h"
#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

constexpr std::uint64_t kTexelBytes = 16;  // RGBA32_UINT

vk::BufferUsageFlags vulkanUsage(Usage usage) {
  using Flag = vk::BufferUsageFlagBits;
  vk::BufferUsageFlags flags = Flag::eTransferSrc | Flag::eTransferDst;
  if (has(usage, Usage::storage)) flags |= Flag::eStorageBuffer;
  if (has(usage, Usage::uniformTexel)) flags |= Flag::eUniformTexelBuffer;
  if (has(usage, Usage::uniform)) flags |= Flag::eUniformBuffer;
  if (has(usage, Usage::indirect)) flags |= Flag::eIndirectBuffer;
  return flags;
}

void requireAtMost(const DeviceInfo& info, std::uint64_t bytes, std::uint64_t limitBytes, const char* kind) {
  if (bytes <= limitBytes) return;
  throw DeviceLimitError(
      fmt::format("cannot create a {} buffer of {} bytes on {}, which binds at most {} bytes at once", kind, bytes,
                  info.name, limitBytes));
}

void requireBindable(const Device::Impl& device, std::uint64_t bytes, Usage usage) {
  const DeviceInfo& info = device.info;
  if (bytes == 0 || bytes % 4 != 0) throw InternalError(fmt::format("a buffer of {} bytes", bytes));
  if (has(usage, Usage::storage)) requireAtMost(info, bytes, info.maxStorageBufferRange, "storage");
  if (has(usage, Usage::uniform)) requireAtMost(info, bytes, device.limits.maxUniformBufferRange, "uniform");
  if (!has(usage, Usage::uniformTexel)) return;
  requireAtMost(info, bytes, info.maxTexelBufferElements * kTexelBytes, "texel");
  if (bytes % kTexelBytes != 0) throw InternalError(fmt::format("a texel buffer of {} bytes", bytes));
}

/// Calls f(offset, size) for consecutive chunks of `bytes` with at most `chunkBytes` (rounded down to whole words)
/// each.
template <class F>
void forEachChunk(std::uint64_t bytes, std::uint64_t chunkBytes, F&& f) {
  for (std::uint64_t begin = 0; begin < bytes; begin += chunkBytes) f(begin, std::min(chunkBytes, bytes - begin));
}

}  // namespace

Buffer::Impl::Impl(std::shared_ptr<Device::Impl> owner, std::uint64_t bytes, Usage uses)
    : device(std::move(owner)), usage(uses) {
  requireBindable(*device, bytes, usage);
  const bool onHost = has(usage, Usage::readback);
  raw = allocate(*device, bytes, vulkanUsage(usage), onHost ? MemoryPreference::host : MemoryPreference::device);
  if (has(usage, Usage::uniformTexel)) {
    texelView = guarded("create a texel view", [&] {
      return device->handle.createBufferView({{}, *raw.handle, vk::Format::eR32G32B32A32Uint, 0, VK_WHOLE_SIZE});
    });
  }
  if (device->options.recording != nullptr) {
    index = static_cast<std::uint32_t>(device->options.recording->buffers.size());
    device->options.recording->buffers.push_back({bytes, usage});
  }
  device->memory.add(raw.bytes, raw.isInSystemMemory);
}

Buffer::Impl::~Impl() { device->memory.remove(raw.bytes, raw.isInSystemMemory); }

void Buffer::Impl::requireRange(std::uint64_t offset, std::uint64_t size) const {
  const bool isInside = offset <= raw.bytes && size <= raw.bytes - offset;
  if (isInside && offset % 4 == 0 && size % 4 == 0) return;
  throw InternalError(fmt::format("{} bytes at {} of a buffer of {} bytes", size, offset, raw.bytes));
}

Buffer::Buffer(Device& device, std::uint64_t bytes, Usage usage)
    : impl_(std::make_shared<Impl>(device.impl(), bytes, usage)) {
  impl_->device->residents.add(impl_);
}

std::uint64_t Buffer::bytes() const { return impl_->raw.bytes; }
bool Buffer::isOn(const Device& device) const { return impl_->device == device.impl(); }
bool Buffer::isMapped() const { return impl_->raw.mapped != nullptr; }

std::span<std::byte> Buffer::mapped() const {
  if (!has(impl_->usage, Usage::readback)) throw InternalError("mapped() of a buffer that is not for readback");
  return {impl_->raw.mapped, static_cast<std::size_t>(impl_->raw.bytes)};
}

void Buffer::upload(std::span<const std::byte> data, std::uint64_t offset) {
  impl_->requireRange(offset, data.size());
  impl_->device->note([&] { return RecordedWrite{impl_->index, offset, {data.begin(), data.end()}}; });
  if (isMapped()) {
    std::copy(data.begin(), data.end(), impl_->raw.mapped + offset);
    return;
  }
  Device::Impl& device = *impl_->device;
  RawBuffer& staging = device.staging();
  forEachChunk(data.size(), staging.bytes, [&](std::uint64_t begin, std::uint64_t size) {
    std::memcpy(staging.mapped, data.data() + begin, size);
    device.run([&](const CommandRecorder::Impl& commands) {
      commands.copy(*staging.handle, 0, *impl_->raw.handle, offset + begin, size);
    });
  });
}

void Buffer::download(std::span<std::byte> data, std::uint64_t offset) const {
  impl_->requireRange(offset, data.size());
  if (isMapped()) {
    std::copy_n(impl_->raw.mapped + offset, data.size(), data.begin());
    return;
  }
  Device::Impl& device = *impl_->device;
  RawBuffer& staging = device.staging();
  forEachChunk(data.size(), staging.bytes, [&](std::uint64_t begin, std::uint64_t size) {
    device.run([&](const CommandRecorder::Impl& commands) {
      commands.copy(*impl_->raw.handle, offset + begin, *staging.handle, 0, size);
    });
    std::memcpy(data.data() + begin, staging.mapped, size);
  });
}

void Buffer::fill(std::uint32_t word) {
  impl_->device->run([&](const CommandRecorder::Impl& commands) { CommandRecorder(commands).fillBuffer(*this, word); });
}

}  // namespace candela::vulkan
