// Caches the pipelines of a renderer: drivers take long to compile one, and the next render often needs the same.
#pragma once
#include <cstddef>
#include <list>
#include <mutex>
#include <span>

#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::device {

/// Caches the pipelines that were used last. Sessions on several threads may share a store.
class PipelineStore {
 public:
  /// Maximum number of pipelines. It suffices for a render and its replay with several settings each; a sweep evicts
  /// the oldest.
  static constexpr std::size_t kCapacity = 16;

  /// Returns the pipeline of this code with these options, and creates it if it is not cached. Modules are identified
  /// by the address of their words. Throws the exceptions of ComputePipeline's constructor.
  vulkan::ComputePipeline get(vulkan::Device& device, std::span<const std::uint32_t> spirv,
                              const vulkan::PipelineOptions& options);

 private:
  struct Entry {
    const std::uint32_t* code;
    vulkan::PipelineOptions options;
    vulkan::ComputePipeline pipeline;
  };

  std::mutex mutex_;
  std::list<Entry> entries_;  // most recently used first
};

}  // namespace candela::device
