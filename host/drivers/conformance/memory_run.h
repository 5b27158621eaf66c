// Runs a function of shaders/conformance/memory.comp.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/drivers/conformance/case_pipeline.h"
#include "host/drivers/conformance/mismatches.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

using WordList = std::vector<std::uint32_t>;

/// The bindings of the shader.
inline constexpr std::uint32_t kMemoryData = 0, kMemoryOutputs = 1;

/// One case. `check` compares the buffers after the run with what they must contain.
struct MemoryRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of the shader
  std::uint32_t invocations;
  std::uint32_t parameter;
  std::uint32_t dataWords;           ///< of the buffer that invocations share
  std::vector<std::uint32_t> first;  ///< its first words before; the others are 0
  void (*check)(const MemoryRow& row, std::span<const std::uint32_t> data, std::span<const std::uint32_t> outputs,
                Mismatches& mismatches);
};

/// Returns the pipeline for a function of the shader.
CasePipeline memoryPipeline(std::uint32_t function);

Finding runMemory(const MemoryRow& row, vulkan::Device& device);

/// Returns the words of a buffer.
WordList wordsOf(const vulkan::Buffer& buffer);

}  // namespace candela::conformance
