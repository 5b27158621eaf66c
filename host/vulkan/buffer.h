// A buffer of device memory that the host fills and reads, directly or through staging.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace candela::vulkan {

class Device;

/// What a buffer is used for; values combine with `|`.
enum class Usage : std::uint32_t {
  storage = 1,       ///< bound as a storage buffer; at most DeviceInfo::maxStorageBufferRange bytes
  uniformTexel = 2,  ///< bound as a `usamplerBuffer`, one view of RGBA32_UINT over the whole: a multiple of 16 bytes,
                     ///< at most DeviceInfo::maxTexelBufferElements texels
  uniform = 4,       ///< bound as a uniform buffer (at most 16 KiB everywhere)
  readback = 8,      ///< lives in memory that the host maps: for counters read after each run. See mapped().
  indirect = 16,     ///< holds the workgroups of dispatches: see CommandRecorder::dispatchIndirect
};
constexpr Usage operator|(Usage a, Usage b) {
  return static_cast<Usage>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(Usage set, Usage flag) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(flag)) != 0;
}

/// A buffer of a fixed number of bytes. In device-local memory where there is room, else in any that the device
/// reaches; mapped at once where that memory is also quick for the host (integrated and software devices). Its first
/// content is undefined. Movable; binding sets that name it keep its memory alive.
class Buffer {
 public:
  /// `bytes` > 0 and a multiple of 4. Throws OutOfMemoryError, which names the size asked and the limit met.
  Buffer(Device& device, std::uint64_t bytes, Usage usage);

  std::uint64_t bytes() const;
  /// Whether the host reads and writes the memory itself, without staging.
  bool isMapped() const;
  /// The whole content; only for Usage::readback. Reads see everything up to the last Device::run; nothing may be read
  /// or written while a run goes on.
  std::span<std::byte> mapped() const;

  /// Copies host data in, or out, at `offset`; offset and size are multiples of 4 and lie within the buffer.
  void upload(std::span<const std::byte> data, std::uint64_t offset = 0);
  void download(std::span<std::byte> data, std::uint64_t offset = 0) const;
  /// Sets every word of the buffer to `word`.
  void fill(std::uint32_t word);

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
