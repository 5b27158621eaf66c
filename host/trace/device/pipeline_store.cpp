// Caches pipelines by their code and specialisation.
#include "host/trace/device/pipeline_store.h"

#include <algorithm>

namespace candela::device {

vulkan::ComputePipeline PipelineStore::get(vulkan::Device& device, std::span<const std::uint32_t> spirv,
                                           const vulkan::PipelineOptions& options) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.code == spirv.data() && entry.options == options;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front({spirv.data(), options, vulkan::ComputePipeline(device, spirv, options)});
    if (entries_.size() > kCapacity) entries_.pop_back();
  }
  return entries_.front().pipeline;
}

}  // namespace candela::device
