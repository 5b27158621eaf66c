// Recreates the buffers, pipelines and commands of a capture.
#include "host/drivers/capture/replay.h"

#include <fmt/format.h>

#include <bit>

#include "host/base/errors.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/device.h"

namespace candela::capture {
namespace {

/// The objects of a capture on a device.
class Replayer {
 public:
  Replayer(const Capture& capture, vulkan::Device& device) {
    for (std::size_t i = 0; i < capture.work.buffers.size(); ++i) {
      buffers_.emplace_back(device, capture.work.buffers[i].bytes, capture.work.buffers[i].usage);
      buffers_.back().upload(capture.contents[i]);
    }
    for (const vulkan::RecordedShader& shader : capture.work.shaders) {
      vulkan::PipelineOptions options = shader.options;
      options.isFinal = true;
      pipelines_.emplace_back(device, shader.spirv, options);
    }
    for (const vulkan::RecordedCommand& command : capture.work.commands) bind(command);
  }

  void record(const std::vector<vulkan::RecordedCommand>& commands, vulkan::CommandRecorder& recorder) {
    nextBinding_ = 0;
    for (const vulkan::RecordedCommand& command : commands) {
      std::visit([&](const auto& one) { recordOne(one, recorder); }, command);
    }
  }

  std::vector<Content> contents() const {
    std::vector<Content> all;
    for (const vulkan::Buffer& buffer : buffers_) {
      all.emplace_back(buffer.bytes());
      buffer.download(all.back());
    }
    return all;
  }

 private:
  void bind(const vulkan::RecordedCommand& command) {
    const auto* const dispatch = std::get_if<vulkan::RecordedDispatch>(&command);
    if (dispatch == nullptr) return;
    std::vector<const vulkan::Buffer*> bound;
    for (const std::uint32_t buffer : dispatch->buffers) bound.push_back(&buffers_[buffer]);
    bindings_.emplace_back(pipelines_[dispatch->shader], bound);
  }

  void recordOne(const vulkan::RecordedWrite& write, vulkan::CommandRecorder& recorder) {
    recorder.updateBuffer(buffers_[write.buffer], write.offset, write.data);
  }
  void recordOne(const vulkan::RecordedFill& fill, vulkan::CommandRecorder& recorder) {
    recorder.fillBuffer(buffers_[fill.buffer], fill.word, fill.offset, fill.bytes);
  }
  void recordOne(const vulkan::RecordedCopy& copy, vulkan::CommandRecorder& recorder) {
    recorder.copyBuffer(buffers_[copy.from], copy.fromOffset, buffers_[copy.to], copy.toOffset, copy.bytes);
  }
  void recordOne(const vulkan::RecordedDispatch& dispatch, vulkan::CommandRecorder& recorder) {
    const vulkan::ComputePipeline& pipeline = pipelines_[dispatch.shader];
    const vulkan::BindingSet& bindings = bindings_[nextBinding_++];
    if (!dispatch.indirect) {
      recorder.dispatch(pipeline, bindings, dispatch.pushConstants, dispatch.groups);
    } else {
      recorder.dispatchIndirect(pipeline, bindings, dispatch.pushConstants, buffers_[dispatch.indirect->buffer],
                                dispatch.indirect->offset);
    }
  }

  std::vector<vulkan::Buffer> buffers_;
  std::vector<vulkan::ComputePipeline> pipelines_;
  std::vector<vulkan::BindingSet> bindings_;  ///< one for each dispatch
  std::size_t nextBinding_ = 0;
};

std::string mismatchText(const ExpectedValue& value, double found) {
  const std::string permitted = value.low == value.high ? fmt::format("{:.9g}", value.low)
                                                        : fmt::format("{:.9g} to {:.9g}", value.low, value.high);
  return fmt::format("binding {}, word {}: expected {}, found {:.9g}", value.position.binding, value.position.word,
                     permitted, found);
}

}  // namespace

std::vector<Content> replay(const Capture& capture, const vulkan::DeviceInfo& info) {
  vulkan::Device device = vulkan::Device::open(
      info, {.robustBufferAccess = capture.work.robustBufferAccess, .subgroupSize = capture.work.subgroupSize});
  Replayer replayer(capture, device);
  device.run([&](vulkan::CommandRecorder& recorder) { replayer.record(capture.work.commands, recorder); });
  return replayer.contents();
}

std::span<const std::uint32_t> wordsOf(const Capture& capture, const ExpectedValue& value,
                                       const std::vector<Content>& contents) {
  const Content& content = contents[bufferOf(capture, value.position)];
  const std::span words(reinterpret_cast<const std::uint32_t*>(content.data()), content.size() / sizeof(std::uint32_t));
  return words.subspan(value.position.word, value.type == ValueType::sum ? 3 : 1);
}

double valueOf(ValueType type, std::span<const std::uint32_t> words) {
  if (type == ValueType::word) return words[0];
  if (type == ValueType::number) return static_cast<double>(std::bit_cast<float>(words[0]));
  return 0x1p24 * words[2] + 0x1p-8 * words[1] + 0x1p-40 * words[0];
}

void check(Capture& capture, const vulkan::DeviceInfo& device) {
  const std::vector<Content> contents = replay(capture, device);
  capture.differing = 0;
  std::string first;
  for (const ExpectedValue& value : capture.expected) {
    const double found = valueOf(value.type, wordsOf(capture, value, contents));
    if (found >= value.low && found <= value.high) continue;
    if (capture.differing++ == 0) first = mismatchText(value, found);
  }
  capture.found.clear();
  if (capture.differing > 0) {
    capture.found = fmt::format("{} of {} values differ:\n{}", capture.differing, capture.expected.size(), first);
  }
}

void expectBitsOf(Capture& capture, const vulkan::DeviceInfo& device) {
  const std::vector<Content> contents = replay(capture, device);
  ExpectedValues bits;
  for (const ExpectedValue& value : capture.expected) {
    const std::span<const std::uint32_t> words = wordsOf(capture, value, contents);
    for (std::uint32_t k = 0; k < words.size(); ++k) {
      const double word = words[k];
      bits.push_back({ValueType::word, {value.position.binding, value.position.word + k}, word, word});
    }
  }
  capture.expected = std::move(bits);
  capture.expectedBy = fmt::format("{} ({})", device.name, device.driver);
  capture.found.clear();
}

}  // namespace candela::capture
