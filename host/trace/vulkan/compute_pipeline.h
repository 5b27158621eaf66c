// A compute pipeline: a shader with its bindings of set 0, push constants and specialisation constants.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "host/trace/vulkan/shader_code.h"

namespace candela::vulkan {

class Device;

enum class BindingKind { storageBuffer, uniformTexelBuffer, uniformBuffer };

struct PipelineOptions {
  std::vector<BindingKind> bindings;    ///< bindings[i] is layout(set = 0, binding = i)
  std::uint32_t pushConstantBytes = 0;  ///< a multiple of 4, at most 128
  std::vector<Specialisation> specialisations{};
  std::string entry = "main";
  /// The driver gets the module unchanged: it has no specialisation constants, and the code of a recording is repeated.
  bool isFinal = false;
  bool operator==(const PipelineOptions&) const = default;
};

/// A pipeline with one compute shader. Some drivers compile at construction, others (lavapipe) at the first dispatch.
class ComputePipeline {
 public:
  /// `spirv` is a SPIR-V module for Vulkan 1.2. Throws OutOfMemoryError, or InternalError if the driver refuses it.
  ComputePipeline(Device& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options);

  struct Impl;
  const std::shared_ptr<Impl>& impl() const { return impl_; }

 private:
  std::shared_ptr<Impl> impl_;
};

}  // namespace candela::vulkan
