// Runs the shader once, and reads both of its buffers.
#include "host/drivers/conformance/memory_run.h"

#include <array>

#include "host/base/divide_up.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "spirv/memory.h"

namespace candela::conformance {

WordList wordsOf(const vulkan::Buffer& buffer) {
  WordList words(buffer.bytes() / sizeof(std::uint32_t));
  buffer.download(std::as_writable_bytes(std::span(words)));
  return words;
}

CasePipeline memoryPipeline(std::uint32_t function) {
  return pipelineOf({.spirv = spirv::memory, .specialisations = {{0, function}}});
}

Finding runMemory(const MemoryRow& row, vulkan::Device& device) {
  const std::array<std::uint32_t, 2> push{row.invocations, row.parameter};
  const vulkan::ComputePipeline pipeline = create(memoryPipeline(row.function), device);
  vulkan::Buffer data(device, row.dataWords * sizeof(std::uint32_t), vulkan::Usage::storage);
  vulkan::Buffer outputs(device, row.invocations * sizeof(std::uint32_t), vulkan::Usage::storage);
  data.fill(0);
  if (!row.first.empty()) data.upload(std::as_bytes(std::span(row.first)));
  outputs.fill(0);
  const vulkan::BindingSet bindings(pipeline, {&data, &outputs});
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), {.x = divideUp(row.invocations, 64u)});
  });
  Mismatches mismatches;
  row.check(row, wordsOf(data), wordsOf(outputs), mismatches);
  return mismatches.finding();
}

}  // namespace candela::conformance
