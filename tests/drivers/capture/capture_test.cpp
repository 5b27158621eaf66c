// Recordings that are reduced to their last dispatch.
#include "host/drivers/capture/capture.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "host/base/errors.h"
#include "host/drivers/capture/header_text.h"
#include "tests/app/cli/run_program.h"

namespace candela::capture {
namespace {

using vulkan::RecordedCopy;
using vulkan::RecordedDispatch;
using vulkan::RecordedFill;
using vulkan::RecordedWrite;

Content bytesOf(const std::vector<std::uint32_t>& words) {
  Content content(words.size() * sizeof(std::uint32_t));
  if (!words.empty()) std::memcpy(content.data(), words.data(), content.size());
  return content;
}

RecordedDispatch dispatchOn(std::uint32_t shader, std::vector<std::uint32_t> buffers) {
  return {shader, std::move(buffers), bytesOf({1, 2}), {.x = 3}, {}};
}

vulkan::Recording recordingWith(std::vector<vulkan::RecordedCommand> commands) {
  vulkan::Recording recording;
  for (std::uint32_t i = 0; i < 3; ++i) {
    recording.shaders.push_back(
        {{100 + i}, {.bindings = {2, vulkan::BindingKind::storageBuffer}, .pushConstantBytes = 8}});
  }
  for (std::uint32_t i = 0; i < 5; ++i) recording.buffers.push_back({16, vulkan::Usage::storage});
  recording.commands = std::move(commands);
  return recording;
}

}  // namespace

TEST_CASE("Commands before the first dispatch become initial contents of the buffers") {
  const Capture capture = cutDown(
      recordingWith({RecordedFill{4, 0, 16, 7}, RecordedWrite{4, 4, bytesOf({8, 9})}, RecordedCopy{4, 0, 2, 8, 8},
                     dispatchOn(1, {2, 4}), RecordedWrite{2, 0, bytesOf({5})}}));
  REQUIRE(capture.work.commands.size() == 1);
  REQUIRE(capture.work.buffers.size() == 2);
  CHECK(capture.contents[bufferOf(capture, {0, 0})] == bytesOf({0, 0, 7, 8}));
  CHECK(capture.contents[bufferOf(capture, {1, 0})] == bytesOf({7, 8, 9, 7}));
  REQUIRE(capture.work.shaders.size() == 1);
  CHECK(capture.work.shaders.front().spirv == std::vector<std::uint32_t>{101});
  CHECK(lastDispatch(capture.work).shader == 0);
}

TEST_CASE("Commands on other buffers are removed") {
  const Capture capture = cutDown(
      recordingWith({RecordedWrite{0, 0, bytesOf({1})}, dispatchOn(0, {0, 1}), RecordedFill{2, 0, 16, 3},
                     RecordedWrite{0, 0, bytesOf({2})}, dispatchOn(2, {2, 3})}));
  CHECK(capture.work.commands.size() == 1);
  CHECK(capture.work.shaders.front().spirv == std::vector<std::uint32_t>{102});
  CHECK(capture.contents[bufferOf(capture, {0, 0})] == bytesOf({3, 3, 3, 3}));
}

TEST_CASE("Dispatches on whose results the last one depends remain, with the commands between them") {
  RecordedDispatch indirect = dispatchOn(2, {2, 3});
  indirect.indirect = {1, 4};
  const Capture capture = cutDown(recordingWith({RecordedFill{0, 0, 16, 3}, dispatchOn(0, {0, 1}),
                                                 RecordedCopy{1, 0, 2, 0, 16}, RecordedFill{4, 0, 16, 1}, indirect}));
  REQUIRE(capture.work.commands.size() == 3);
  CHECK(capture.work.shaders.size() == 2);
  CHECK(capture.work.buffers.size() == 4);
  const auto& copy = std::get<RecordedCopy>(capture.work.commands[1]);
  CHECK(copy.from == lastDispatch(capture.work).indirect->buffer);
  CHECK(copy.to == bufferOf(capture, {0, 0}));
}

TEST_CASE("Work without a dispatch cannot be captured") {
  CHECK_THROWS_AS(cutDown(recordingWith({RecordedFill{0, 0, 16, 3}})), InternalError);
}

TEST_CASE("The header names the files of buffers, and the words of those that begin with equal ones") {
  Capture capture = cutDown(
      recordingWith({RecordedFill{0, 0, 16, 0xdeadbeefu}, RecordedWrite{1, 0, bytesOf({1, 2, 3, 4})},
                     dispatchOn(0, {0, 1}), RecordedWrite{1, 4, bytesOf({9})}, dispatchOn(1, {1, 0})}));
  capture.title = "a \"title\"\nwith \\";
  const std::string header = headerText(capture);
  CHECK(contains(header, "#define CAPTURE_TITLE \"a \\\"title\\\" with \\\\\"\n"));
  CHECK(contains(header, "{\"module_1.spv\", 8, 2, {USE_STORAGE, USE_STORAGE}}"));
  CHECK(contains(header, "{NULL, 16, USE_STORAGE, 0xdeadbeefu}"));
  CHECK(contains(header, "{\"buffer_1.bin\", 16, USE_STORAGE, 0x0u}"));
  CHECK(contains(header, ".kind = COMMAND_WRITE, .buffer = 1, .offset = 4, .file = \"write_1.bin\""));
  CHECK(contains(header, ".module = 1, .buffers = {1, 0}, .push = {0x1u, 0x2u}, .groups = {3, 1, 1}"));
}

TEST_CASE("Work with more buffers than the program takes is refused") {
  vulkan::Recording recording = recordingWith({});
  for (std::uint32_t i = 0; i < 80; ++i) {
    recording.buffers.push_back({16, vulkan::Usage::storage});
    recording.commands.emplace_back(dispatchOn(0, {0, 5 + i}));
  }
  CHECK_THROWS_AS(headerText(cutDown(recording)), UsageError);
}

}  // namespace candela::capture
