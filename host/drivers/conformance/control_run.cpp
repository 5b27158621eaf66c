// Runs control flow.
#include "host/drivers/conformance/control_run.h"

#include <fmt/format.h>

#include "host/drivers/conformance/mismatches.h"
#include "spirv/control.h"

namespace candela::conformance {

namespace {

ShaderRun shaderOf(const ControlRow& row) {
  return {spirv::control, row.invocations, row.parameter, {{0, row.function}}};
}

}  // namespace

CasePipeline pipelineOf(const ControlRow& row) { return pipelineOf(shaderOf(row)); }

Finding runControl(const ControlRow& row, vulkan::Device& device) {
  std::vector<std::uint32_t> inputs;
  for (std::uint32_t i = 0; i < row.invocations; ++i) inputs.push_back(nextWord(i));
  const std::vector<Words> found = runShader<Words>(device, shaderOf(row), inputs, inputs.size());
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < row.invocations; ++i) {
    const Words expected = row.twin(inputs[i], row.parameter);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      mismatches.expect(fmt::format("{}({:#x}), invocation {}, value {}", row.name, inputs[i], i, k),
                        outputPosition(i, k), expected[k], found[i][k]);
    }
  }
  return perInvocation(mismatches.finding());
}

}  // namespace candela::conformance
