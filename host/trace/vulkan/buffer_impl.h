// The Vulkan handles of a Buffer.
#pragma once
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/device_impl.h"

namespace candela::vulkan {

struct Buffer::Impl {
  std::shared_ptr<Device::Impl> device;
  RawBuffer raw;
  Usage usage;
  std::uint32_t index = 0;                  ///< in Recording::buffers, if the device has a recording
  vk::raii::BufferView texelView{nullptr};  ///< for Usage::uniformTexel

  Impl(std::shared_ptr<Device::Impl> device, std::uint64_t bytes, Usage usage);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Throws InternalError unless [offset, offset + size) is within the buffer and both are multiples of 4.
  void requireRange(std::uint64_t offset, std::uint64_t size) const;
};

}  // namespace candela::vulkan
