// Finds the commands that matter, backwards from the last dispatch, and applies those before the first dispatch.
#include "host/drivers/capture/capture.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "host/base/errors.h"

namespace candela::capture {
namespace {

using vulkan::RecordedCommand;
using vulkan::RecordedCopy;
using vulkan::RecordedDispatch;
using vulkan::RecordedFill;
using vulkan::RecordedWrite;
using vulkan::Recording;

bool isDispatch(const RecordedCommand& command) { return std::holds_alternative<RecordedDispatch>(command); }

// Buffers whose content decides the expected values, as the search goes back from the last dispatch.
class NeededBuffers {
 public:
  /// Returns whether the command decides the content of a needed buffer; the buffers that it reads are needed from then
  /// on.
  bool take(const RecordedCommand& command) {
    return std::visit([&](const auto& one) { return takeOne(one); }, command);
  }

 private:
  bool takeOne(const RecordedWrite& write) const { return indices_.contains(write.buffer); }
  bool takeOne(const RecordedFill& fill) const { return indices_.contains(fill.buffer); }
  bool takeOne(const RecordedCopy& copy) {
    if (!indices_.contains(copy.to)) return false;
    indices_.insert(copy.from);
    return true;
  }
  bool takeOne(const RecordedDispatch& dispatch) {
    const bool matters = indices_.empty() || std::ranges::any_of(dispatch.buffers, [&](std::uint32_t buffer) {
                           return indices_.contains(buffer);
                         });
    if (!matters) return false;
    indices_.insert(dispatch.buffers.begin(), dispatch.buffers.end());
    if (dispatch.indirect) indices_.insert(dispatch.indirect->buffer);
    return true;
  }

  std::set<std::uint32_t> indices_;
};

std::vector<RecordedCommand> neededCommands(const Recording& recording) {
  NeededBuffers needed;
  std::vector<RecordedCommand> commands;
  const auto last = std::find_if(recording.commands.rbegin(), recording.commands.rend(), isDispatch);
  for (auto command = last; command != recording.commands.rend(); ++command) {
    if (needed.take(*command)) commands.push_back(*command);
  }
  std::ranges::reverse(commands);
  return commands;
}

/// Gives the shaders and buffers that commands refer to new indices, in the order of their first use.
class Compaction {
 public:
  explicit Compaction(const Recording& from) : from_(from) {}

  void renumber(RecordedWrite& write) { buffer(write.buffer); }
  void renumber(RecordedFill& fill) { buffer(fill.buffer); }
  void renumber(RecordedCopy& copy) {
    buffer(copy.from);
    buffer(copy.to);
  }
  void renumber(RecordedDispatch& dispatch) {
    const auto [found, isNew] = shaders_.try_emplace(dispatch.shader, static_cast<std::uint32_t>(to.shaders.size()));
    if (isNew) to.shaders.push_back(from_.shaders.at(dispatch.shader));
    dispatch.shader = found->second;
    for (std::uint32_t& index : dispatch.buffers) buffer(index);
    if (dispatch.indirect) buffer(dispatch.indirect->buffer);
  }

  Recording to;

 private:
  void buffer(std::uint32_t& index) {
    const auto [found, isNew] = buffers_.try_emplace(index, static_cast<std::uint32_t>(to.buffers.size()));
    if (isNew) to.buffers.push_back(from_.buffers.at(index));
    index = found->second;
  }

  const Recording& from_;
  std::map<std::uint32_t, std::uint32_t> shaders_, buffers_;
};

void apply(const RecordedWrite& write, std::vector<Content>& contents) {
  std::ranges::copy(write.data, contents[write.buffer].begin() + static_cast<std::ptrdiff_t>(write.offset));
}

void apply(const RecordedFill& fill, std::vector<Content>& contents) {
  for (std::uint64_t at = fill.offset; at < fill.offset + fill.bytes; at += sizeof fill.word) {
    std::memcpy(&contents[fill.buffer][at], &fill.word, sizeof fill.word);
  }
}

void apply(const RecordedCopy& copy, std::vector<Content>& contents) {
  std::memmove(&contents[copy.to][copy.toOffset], &contents[copy.from][copy.fromOffset], copy.bytes);
}

void apply(const RecordedDispatch&, std::vector<Content>&) {
  throw InternalError("a dispatch cannot be applied on the host");
}

template <class R>
auto& lastDispatchOf(R& recording) {
  const auto last = std::find_if(recording.commands.rbegin(), recording.commands.rend(), isDispatch);
  if (last == recording.commands.rend()) throw InternalError("nothing was dispatched");
  return std::get<RecordedDispatch>(*last);
}

}  // namespace

Capture cutDown(const Recording& recording) {
  lastDispatch(recording);
  std::vector<RecordedCommand> commands = neededCommands(recording);
  Compaction compaction(recording);
  for (RecordedCommand& command : commands) {
    std::visit([&](auto& one) { compaction.renumber(one); }, command);
  }
  Capture capture;
  capture.work = std::move(compaction.to);
  capture.work.robustBufferAccess = recording.robustBufferAccess;
  capture.work.subgroupSize = recording.subgroupSize;
  for (const vulkan::RecordedBuffer& buffer : capture.work.buffers) capture.contents.emplace_back(buffer.bytes);
  const auto first = std::ranges::find_if(commands, isDispatch);
  for (auto command = commands.begin(); command != first; ++command) {
    std::visit([&](const auto& one) { apply(one, capture.contents); }, *command);
  }
  capture.work.commands.assign(first, commands.end());
  return capture;
}

const RecordedDispatch& lastDispatch(const Recording& recording) { return lastDispatchOf(recording); }
RecordedDispatch& lastDispatch(Recording& recording) { return lastDispatchOf(recording); }

std::uint32_t bufferOf(const Capture& capture, const WordPosition& position) {
  return lastDispatch(capture.work).buffers.at(position.binding);
}

}  // namespace candela::capture
