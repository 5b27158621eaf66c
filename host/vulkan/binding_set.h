// Which buffers a pipeline's bindings stand for.
#pragma once
#include <memory>
#include <vector>

namespace candela::vulkan {

class Buffer;
class ComputePipeline;

/// Buffers bound to set 0 of a pipeline, in the order of its bindings. Keeps them and the pipeline alive. One set
/// serves any pipeline made with equal bindings and push constants.
class BindingSet {
 public:
  /// As many buffers as the pipeline has bindings, each made for that use; throws InternalError if not.
  BindingSet(const ComputePipeline& pipeline, const std::vector<const Buffer*>& buffers);

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
