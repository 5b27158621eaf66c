// Writes the README.md of a capture.
#include "host/drivers/capture/readme_text.h"

#include <fmt/format.h>

namespace candela::capture {
namespace {

std::string countText(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

// Returns sentences, each after a space.
std::string remarksOf(const Capture& capture) {
  std::string text;
  if (capture.wholeCount > 0) text += fmt::format(" They were reduced from {} values.", capture.wholeCount);
  if (!capture.note.empty()) text += " " + capture.note;
  return text;
}

std::string foundText(const Capture& capture) {
  if (capture.found.empty()) {
    return fmt::format("It was captured on {}, which computed these values.", capture.capturedOn);
  }
  return fmt::format("On {}:\n\n```\n{}\n```", capture.capturedOn, capture.found);
}

}  // namespace

std::string readmeText(const Capture& capture) {
  return fmt::format(
      R"(# {}

The program in this folder repeats work of Candela, a path tracer that verifies Vulkan drivers, on any Vulkan 1.2 device: {} with {} and {}.
It compares {} of the result with those that {} computed.{} {}

## How to run it

    cc -std=c99 -o reproduce reproduce.c -lvulkan
    ./reproduce                                           # on the first device
    VK_DRIVER_FILES=/path/to/icd.json ./reproduce         # with this driver

It prints the first value that differs. The exit code is 0 if no value differs, 1 if one does, and 2 if Vulkan cannot run it.

## Files

- `reproduce.c` and `capture.h`: the program and its tables.
- `module_*.spv`: the shaders as they are passed to the driver; specialisation constants are set, and the code that they disable is removed.
- `buffer_*.bin`, `write_*.bin`: contents of buffers. Buffers without a file begin with equal words.
- `expected.bin`: records of 32 bytes (type, buffer, word, 0, minimum and maximum permitted value as doubles).
- `minimum.txt`: number of values that must differ when the shader is reduced.
- `interesting.sh`: tests whether two executions of a module disagree.
- `reduce.sh`: reduces a module as long as `interesting.sh` accepts it.

## How to reduce the shader

    export ICD_A=/path/to/icd.json ICD_B=/path/to/another/icd.json
    ./reduce.sh module_0.spv reduced.spv
    ICD=$ICD_A; VK_DRIVER_FILES=$ICD ./reproduce --module 0 reduced.spv --dump a
    ICD=$ICD_B; VK_DRIVER_FILES=$ICD ./reproduce --module 0 reduced.spv --against a 0.001

It needs SPIRV-Tools. A reduced module computes something else, so that two executions are compared instead of the expected values.
)",
      capture.title, countText(capture.work.commands.size(), "command", "commands"),
      countText(capture.work.shaders.size(), "shader", "shaders"),
      countText(capture.work.buffers.size(), "buffer", "buffers"),
      countText(capture.expected.size(), "value", "values"), capture.expectedBy, remarksOf(capture),
      foundText(capture));
}

}  // namespace candela::capture
