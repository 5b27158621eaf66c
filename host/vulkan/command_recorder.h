// What can be asked of the device within one submission: dispatches, fills and copies, each after the one before.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace candela::vulkan {

class BindingSet;
class Buffer;
class ComputePipeline;

struct GroupCount {
  std::uint32_t x = 1, y = 1, z = 1;  ///< workgroups, each 1 to 65,535
};

/// Records commands into the submission of one Device::run. Each command sees all that earlier ones wrote: a barrier
/// stands between any two. Commands that could overlap are thus kept apart; here nearly all depend on the one before.
class CommandRecorder {
 public:
  /// Runs `pipeline` on `bindings`. `pushConstants` has the size that the pipeline was made with.
  void dispatch(const ComputePipeline& pipeline, const BindingSet& bindings, std::span<const std::byte> pushConstants,
                GroupCount groups);
  /// The same, with workgroups that the device itself wrote: three words of `groups`, made for Usage::indirect, at
  /// `offset` (a multiple of 4). No workgroup at all is fine; the caller answers for the device's limits.
  void dispatchIndirect(const ComputePipeline& pipeline, const BindingSet& bindings,
                        std::span<const std::byte> pushConstants, const Buffer& groups, std::uint64_t offset);
  /// Sets `bytes` (a multiple of 4) of `buffer` at `offset` (a multiple of 4) to `word`.
  void fillBuffer(const Buffer& buffer, std::uint32_t word, std::uint64_t offset, std::uint64_t bytes);
  void fillBuffer(const Buffer& buffer, std::uint32_t word);
  /// Writes up to 64 KiB, which it takes at once, into `buffer` at `offset`, both multiples of 4.
  void updateBuffer(const Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data);
  /// Copies `bytes` from one buffer into another, or within one if the two ranges are apart.
  void copyBuffer(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
                  std::uint64_t bytes);

  /// Made by Device::run alone.
  struct Impl;
  explicit CommandRecorder(const Impl& impl) : impl_(impl) {}
  CommandRecorder(const CommandRecorder&) = delete;
  CommandRecorder& operator=(const CommandRecorder&) = delete;

 private:
  void prepareDispatch(const ComputePipeline& pipeline, const BindingSet& bindings,
                       std::span<const std::byte> pushConstants);

  const Impl& impl_;
};

}  // namespace candela::vulkan
