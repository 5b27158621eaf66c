// The commands of one submission: dispatches, fills and copies, executed sequentially.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace candela::vulkan {

class BindingSet;
class Buffer;
class ComputePipeline;

struct GroupCount {
  std::uint32_t x = 1, y = 1, z = 1;  ///< numbers of workgroups, each 1 to 65,535
};

/// Records commands into the submission of one Device::run. There is a barrier between any two commands, so that each
/// sees everything that earlier ones wrote. Commands that could overlap are thus serialised; here, nearly all depend on
/// the one before.
class CommandRecorder {
 public:
  /// Runs `pipeline` on `bindings`. `pushConstants` has the size with which the pipeline was created.
  void dispatch(const ComputePipeline& pipeline, const BindingSet& bindings, std::span<const std::byte> pushConstants,
                GroupCount groups);
  /// Runs a pipeline with workgroup counts written by the device: three words of `groups`, created for Usage::indirect,
  /// at `offset` (a multiple of 4). Counts may be 0; the caller ensures the limits of the device.
  void dispatchIndirect(const ComputePipeline& pipeline, const BindingSet& bindings,
                        std::span<const std::byte> pushConstants, const Buffer& groups, std::uint64_t offset);
  /// Sets `bytes` (a multiple of 4) of `buffer` at `offset` (a multiple of 4) to `word`.
  void fillBuffer(const Buffer& buffer, std::uint32_t word, std::uint64_t offset, std::uint64_t bytes);
  void fillBuffer(const Buffer& buffer, std::uint32_t word);
  /// Writes up to 64 KiB into `buffer` at `offset`, both multiples of 4. The data are copied at once.
  void updateBuffer(const Buffer& buffer, std::uint64_t offset, std::span<const std::byte> data);
  /// Copies `bytes` from one buffer to another, or within one if the two ranges do not overlap.
  void copyBuffer(const Buffer& from, std::uint64_t fromOffset, const Buffer& to, std::uint64_t toOffset,
                  std::uint64_t bytes);

  /// Only Device::run constructs recorders.
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
