// The pipelines that a renderer has made: drivers take long to compile one, and the next render often needs the same.
#pragma once
#include <cstddef>
#include <list>
#include <span>

#include "host/vulkan/compute_pipeline.h"

namespace candela::device {

/// Keeps the pipelines that were used last.
class PipelineStore {
 public:
  /// A render and its replay, with some settings of each, find their pipelines again; a sweep forgets the oldest.
  static constexpr std::size_t kCapacity = 16;

  /// The pipeline of this code with these options; made if it is not there. Two modules are told apart by the address
  /// of their words. Throws what ComputePipeline's constructor throws.
  vulkan::ComputePipeline get(vulkan::Device& device, std::span<const std::uint32_t> spirv,
                              const vulkan::PipelineOptions& options);

 private:
  struct Entry {
    const std::uint32_t* code;
    vulkan::PipelineOptions options;
    vulkan::ComputePipeline pipeline;
  };

  std::list<Entry> entries_;  // the one used last comes first
};

}  // namespace candela::device
