// A buffer in device memory that the host writes and reads, directly or through staging.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace candela::vulkan {

class Device;

/// The uses of a buffer. Values are combined with `|`.
enum class Usage : std::uint32_t {
  storage = 1,       ///< bound as a storage buffer; at most DeviceInfo::maxStorageBufferRange bytes
  uniformTexel = 2,  ///< bound as a `usamplerBuffer`, one view of RGBA32_UINT over the whole: a multiple of 16 bytes,
                     ///< at most DeviceInfo::maxTexelBufferElements texels
  uniform = 4,       ///< bound as a uniform buffer (at most 16 KiB everywhere)
  readback = 8,      ///< in memory that the host maps, for counters that are read after each run. See mapped().
  indirect = 16,     ///< contains the workgroup counts of dispatches: see CommandRecorder::dispatchIndirect
};
constexpr Usage operator|(Usage a, Usage b) {
  return static_cast<Usage>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool has(Usage set, Usage flag) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(flag)) != 0;
}

/// A buffer of a fixed number of bytes, in device-local memory if there is room, else in any memory that the device can
/// access. It is mapped permanently if the host can access this memory fast (integrated and software devices). Its
/// initial content is undefined. Movable; binding sets that refer to it keep its memory alive.
class Buffer {
 public:
  /// `bytes` is > 0 and a multiple of 4. Throws OutOfMemoryError with the requested size and the limit.
  Buffer(Device& device, std::uint64_t bytes, Usage usage);

  std::uint64_t bytes() const;
  /// Returns whether the buffer belongs to this device.
  bool isOn(const Device& device) const;
  /// Returns whether the host accesses the memory directly, without staging.
  bool isMapped() const;
  /// Returns the whole content; only for Usage::readback. It contains everything written up to the last Device::run,
  /// and must not be accessed during a run.
  std::span<std::byte> mapped() const;

  /// Copy host data in or out at `offset`. Offset and size are multiples of 4 and within the buffer.
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
