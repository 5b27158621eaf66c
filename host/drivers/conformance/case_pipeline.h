// The pipelines of cases, which are compiled with or without running them.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "host/drivers/conformance/case.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

struct CasePipeline {
  std::span<const std::uint32_t> spirv;
  vulkan::PipelineOptions options;
};

/// Throws as ComputePipeline's constructor does.
vulkan::ComputePipeline create(const CasePipeline& pipeline, vulkan::Device& device);

/// Returns a case with a single pipeline, on Workbench::device().
Case caseOf(std::string name, std::string group, CasePipeline pipeline, std::function<Finding(Workbench&)> run);

}  // namespace candela::conformance
