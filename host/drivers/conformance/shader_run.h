// Runs a small compute shader over arrays.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/divide_up.h"
#include "host/drivers/capture/expected_value.h"
#include "host/drivers/conformance/case_pipeline.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

/// Four 32-bit values, as a uvec4 of a shader.
using Words = std::array<std::uint32_t, 4>;

/// Invocations in a workgroup of a ShaderRun.
inline constexpr std::uint32_t kRunGroup = 64;

/// The shader has the bindings 0 (inputs) and 1 (outputs), workgroups of 64 invocations and two push constants, of
/// which the first is the number of invocations.
struct ShaderRun {
  std::span<const std::uint32_t> spirv;
  std::uint32_t invocations = 0;
  std::uint32_t parameter = 0;  ///< the second push constant
  std::vector<vulkan::Specialisation> specialisations{};
};

CasePipeline pipelineOf(const ShaderRun& run);

/// The binding of the outputs.
inline constexpr std::uint32_t kOutputs = 1;

/// Returns the position of component `k` of the output vector of an invocation.
constexpr capture::WordPosition outputPosition(std::size_t invocation, std::size_t k) {
  return {kOutputs, static_cast<std::uint32_t>(4 * invocation + k)};
}

/// Runs the shader on `inputs` and returns `outputCount` values that it wrote. Outputs are 0xdeadbeef before.
template <class Output, class Input>
std::vector<Output> runShader(vulkan::Device& device, const ShaderRun& run, const std::vector<Input>& inputs,
                              std::size_t outputCount) {
  constexpr std::uint32_t kUnwritten = 0xdeadbeefu;
  const std::array<std::uint32_t, 2> push{run.invocations, run.parameter};
  const vulkan::ComputePipeline pipeline = create(pipelineOf(run), device);
  vulkan::Buffer in(device, inputs.size() * sizeof(Input), vulkan::Usage::storage);
  vulkan::Buffer out(device, outputCount * sizeof(Output), vulkan::Usage::storage);
  in.upload(std::as_bytes(std::span(inputs)));
  out.fill(kUnwritten);
  const vulkan::BindingSet bindings(pipeline, {&in, &out});
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), {.x = divideUp(run.invocations, kRunGroup)});
  });
  std::vector<Output> outputs(outputCount);
  out.download(std::as_writable_bytes(std::span(outputs)));
  return outputs;
}

}  // namespace candela::conformance
