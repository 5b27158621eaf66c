// Reports on a pipeline: what its driver says (VK_KHR_pipeline_executable_properties), the time to create it, and its
// sizes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::vulkan {

struct ExecutableStatistic {
  std::string name;  ///< in the driver's words
  std::variant<bool, std::int64_t, std::uint64_t, double> value;
};

/// A part of a pipeline that the driver compiled. Most drivers compile a compute shader to one.
struct Executable {
  std::string name;
  std::uint32_t subgroupSize = 0;  ///< with which it is dispatched; 0: unknown
  std::vector<ExecutableStatistic> statistics;
};

struct PipelineReport {
  /// Processor time of all threads to create the pipeline, without the preparation of its SPIR-V.
  double seconds = 0;
  std::size_t spirvBytes = 0;           ///< of the module that the driver gets
  std::size_t cacheBytes = 0;           ///< content of a pipeline cache that has this pipeline alone
  std::vector<Executable> executables;  ///< empty: the driver reports none
};

/// Creates the pipeline with an empty pipeline cache, as a render without a warm cache does, and a second time with
/// VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR if the device was opened with DeviceOptions::compilesOnly and has the
/// extension. Throws as ComputePipeline's constructor does.
PipelineReport reportPipeline(Device& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options);

}  // namespace candela::vulkan
