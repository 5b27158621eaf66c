// The work of a device, recorded so that it can be repeated by another program; this header uses no Vulkan type.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/command_recorder.h"
#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::vulkan {

struct RecordedShader {
  std::vector<std::uint32_t> spirv;  ///< as passed to the driver, with the specialisation constants set to their values
  PipelineOptions options;
};

struct RecordedBuffer {
  std::uint64_t bytes = 0;
  Usage usage = Usage::storage;
};

// Commands. Buffers are indices into Recording::buffers, offsets and sizes are in bytes.

/// An upload by the host, or CommandRecorder::updateBuffer().
struct RecordedWrite {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0;
  std::vector<std::byte> data;
};

struct RecordedFill {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0;
  std::uint64_t bytes = 0;
  std::uint32_t word = 0;
};

struct RecordedCopy {
  std::uint32_t from = 0;
  std::uint64_t fromOffset = 0;
  std::uint32_t to = 0;
  std::uint64_t toOffset = 0;
  std::uint64_t bytes = 0;
};

/// The workgroup counts of an indirect dispatch.
struct RecordedGroups {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0;
};

struct RecordedDispatch {
  std::uint32_t shader = 0;            ///< index into Recording::shaders
  std::vector<std::uint32_t> buffers;  ///< in the order of the bindings
  std::vector<std::byte> pushConstants;
  GroupCount groups;                       ///< unless `indirect`
  std::optional<RecordedGroups> indirect;  ///< of CommandRecorder::dispatchIndirect()
};

using RecordedCommand = std::variant<RecordedWrite, RecordedFill, RecordedCopy, RecordedDispatch>;

/// All work that one device was given, in the order of the calls, except what is written to Buffer::mapped().
struct Recording {
  std::vector<RecordedShader> shaders;
  std::vector<RecordedBuffer> buffers;
  std::vector<RecordedCommand> commands;
  bool robustBufferAccess = false;
  std::uint32_t subgroupSize = 0;  ///< DeviceOptions::subgroupSize
};

}  // namespace candela::vulkan
