// Runs a function of shaders/conformance/control.comp and compares each invocation with its counterpart on the host.
#pragma once
#include "host/drivers/conformance/case_pipeline.h"
#include "host/drivers/conformance/control_twins.h"

namespace candela::conformance {

struct ControlRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of the shader
  ControlTwin twin;
  std::uint32_t parameter = 0;
  std::uint32_t invocations = 1000;  ///< not a multiple of the workgroup size
};

CasePipeline pipelineOf(const ControlRow& row);
Finding runControl(const ControlRow& row, vulkan::Device& device);

}  // namespace candela::conformance
