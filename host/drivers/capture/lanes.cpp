// Tries windows of growing width around the first invocation that fails.
#include "host/drivers/capture/lanes.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "host/base/divide_up.h"
#include "host/drivers/capture/replay.h"

namespace candela::capture {
namespace {

constexpr std::uint32_t kInputs = 0, kOutputs = 1;
constexpr std::size_t kWord = sizeof(std::uint32_t);

/// Invocations first .. first + count - 1.
struct Invocations {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
};

std::uint32_t invocationsOf(const Capture& capture) {
  const std::vector<std::byte>& push = lastDispatch(capture.work).pushConstants;
  std::uint32_t count = 0;
  if (push.size() >= sizeof count) std::memcpy(&count, push.data(), sizeof count);
  return count;
}

std::size_t bytesPerInvocation(const Capture& capture, std::uint32_t binding) {
  return capture.contents[bufferOf(capture, {binding, 0})].size() / invocationsOf(capture);
}

bool isDivided(const Capture& capture) {
  const std::uint32_t count = invocationsOf(capture);
  if (count == 0 || capture.work.commands.size() != 1) return false;
  const auto divides = [&](std::uint32_t binding) {
    return capture.contents[bufferOf(capture, {binding, 0})].size() % (count * kWord) == 0;
  };
  const bool areOutputs = std::ranges::all_of(
      capture.expected, [](const ExpectedValue& value) { return value.position.binding == kOutputs; });
  return areOutputs && divides(kInputs) && divides(kOutputs);
}

std::uint32_t firstFailing(const Capture& capture, const vulkan::DeviceInfo& device) {
  const std::vector<Content> contents = replay(capture, device);
  for (const ExpectedValue& value : capture.expected) {
    const double found = valueOf(value.type, wordsOf(capture, value, contents));
    if (found >= value.low && found <= value.high) continue;
    return static_cast<std::uint32_t>(value.position.word * kWord / bytesPerInvocation(capture, kOutputs));
  }
  return 0;
}

void cutBuffer(Capture& capture, std::uint32_t binding, const Invocations& kept) {
  const std::size_t bytes = bytesPerInvocation(capture, binding);
  const std::uint32_t buffer = bufferOf(capture, {binding, 0});
  Content& content = capture.contents[buffer];
  const auto first = content.begin() + static_cast<std::ptrdiff_t>(bytes * kept.first);
  content = Content(first, first + static_cast<std::ptrdiff_t>(bytes * kept.count));
  capture.work.buffers[buffer].bytes = content.size();
}

void cutExpected(Capture& capture, const Invocations& kept) {
  const auto words = static_cast<std::uint32_t>(bytesPerInvocation(capture, kOutputs) / kWord);
  std::erase_if(capture.expected, [&](const ExpectedValue& value) {
    const std::uint32_t invocation = value.position.word / words;
    return invocation < kept.first || invocation >= kept.first + kept.count;
  });
  for (ExpectedValue& value : capture.expected) value.position.word -= kept.first * words;
}

Capture cutTo(Capture capture, const Invocations& kept, std::uint32_t groupSize) {
  cutExpected(capture, kept);
  cutBuffer(capture, kInputs, kept);
  cutBuffer(capture, kOutputs, kept);
  vulkan::RecordedDispatch& dispatch = lastDispatch(capture.work);
  std::memcpy(dispatch.pushConstants.data(), &kept.count, sizeof kept.count);
  dispatch.groups = {.x = divideUp(kept.count, groupSize)};
  return capture;
}

}  // namespace

void takeFewestInvocations(Capture& capture, const vulkan::DeviceInfo& device, std::uint32_t groupSize) {
  if (capture.differing == 0 || !isDivided(capture)) return;
  const std::uint32_t count = invocationsOf(capture);
  const std::uint32_t failing = firstFailing(capture, device);
  for (std::uint32_t width = 1; width < count; width *= 2) {
    const std::uint32_t first = failing / width * width;
    Capture smaller = cutTo(capture, {first, std::min(width, count - first)}, groupSize);
    check(smaller, device);
    if (smaller.differing == 0) continue;
    smaller.wholeCount = capture.expected.size();
    capture = std::move(smaller);
    return;
  }
}

}  // namespace candela::capture
