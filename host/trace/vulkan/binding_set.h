// The buffers that are bound to a pipeline.
#pragma once
#include <memory>
#include <vector>

namespace candela::vulkan {

class Buffer;
class ComputePipeline;

/// Buffers bound to set 0 of a pipeline, in the order of its bindings. Keeps the buffers and the pipeline alive. One
/// set can be used with any pipeline that was created with equal bindings and push constants.
class BindingSet {
 public:
  /// Throws InternalError unless there are as many buffers as bindings and each was created for its use.
  BindingSet(const ComputePipeline& pipeline, const std::vector<const Buffer*>& buffers);

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
