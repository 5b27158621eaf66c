// Pipelines get every kind of input, and each command sees the writes of earlier ones.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "spirv/combine.h"
#include "spirv/shift_and_increment.h"
#include "tests/trace/vulkan/test_words.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::vulkan;
using vulkan::BindingKind;
using vulkan::BindingSet;
using vulkan::Buffer;
using vulkan::CommandRecorder;
using vulkan::ComputePipeline;
using vulkan::Device;
using vulkan::Usage;

namespace {

const std::vector<BindingKind> kCombineBindings{BindingKind::uniformTexelBuffer, BindingKind::storageBuffer,
                                                BindingKind::uniformBuffer};
const std::vector<BindingKind> kTwoStorageBuffers(2, BindingKind::storageBuffer);

ComputePipeline makeShift(Device& device) {
  return {device, spirv::shift_and_increment, {.bindings = kTwoStorageBuffers}};
}

}  // namespace

TEST_CASE("a shader reads texels, uniforms, push and specialisation constants") {
  const std::uint32_t workgroup = GENERATE(1u, 8u, 64u);
  const std::uint32_t factor = GENERATE(3u, 10u);
  Device device = openTestDevice();
  constexpr std::uint32_t kCount = 1000;
  constexpr std::uint32_t kSummand = 100, kOffset = 7;
  const ComputePipeline pipeline(device, spirv::combine,
                                 {.bindings = kCombineBindings,
                                  .pushConstantBytes = 8,
                                  .specialisations = {{.id = 0, .value = workgroup}, {.id = 1, .value = factor}}});
  Buffer source(device, 4 * kCount, Usage::storage | Usage::uniformTexel);
  Buffer result(device, 4 * (kCount + 1), Usage::storage);
  Buffer offset(device, 16, Usage::uniform);
  const Words words = makeWords(kCount);
  upload(source, words);
  upload(offset, {0, 0, 0, kOffset});
  result.fill(1);

  const BindingSet bindings(pipeline, {&source, &result, &offset});
  const std::array<std::uint32_t, 2> push{kSummand, kCount};
  device.run([&](CommandRecorder& commands) {
    commands.dispatch(pipeline, bindings, std::as_bytes(std::span(push)), {.x = (kCount + workgroup - 1) / workgroup});
  });

  Words expected;
  for (const std::uint32_t word : words) expected.push_back(word * factor + kSummand + kOffset);
  expected.push_back(1);
  CHECK(download(result) == expected);
}

TEST_CASE("a dispatch sees the writes of the previous one") {
  Device device = openTestDevice();
  constexpr std::uint32_t kCount = 4096, kTurns = 50;
  const ComputePipeline pipeline = makeShift(device);
  Buffer a(device, 4 * kCount, Usage::storage);
  Buffer b(device, 4 * kCount, Usage::storage);
  const BindingSet forth(pipeline, {&a, &b});
  const BindingSet back(pipeline, {&b, &a});
  const Words words = makeWords(kCount);
  upload(a, words);
  device.run([&](CommandRecorder& commands) {
    for (std::uint32_t turn = 0; turn < kTurns; ++turn) {
      commands.dispatch(pipeline, forth, {}, {.x = kCount / 64});
      commands.dispatch(pipeline, back, {}, {.x = kCount / 64});
    }
  });
  Words expected(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) expected[i] = words[(i + 2 * kTurns) % kCount] + 2 * kTurns;
  CHECK(download(a) == expected);
}

TEST_CASE("dispatches, fills and copies of one submission are executed in order") {
  Device device = openTestDevice();
  const ComputePipeline pipeline = makeShift(device);
  Buffer a(device, 256, Usage::storage);
  Buffer b(device, 256, Usage::storage);
  Buffer counters(device, 256, Usage::storage | Usage::readback);
  const BindingSet bindings(pipeline, {&a, &b});
  const double seconds = device.run([&](CommandRecorder& commands) {
    commands.fillBuffer(a, 41);
    commands.dispatch(pipeline, bindings, {}, {});
    commands.copyBuffer(b, 0, counters, 0, 256);
    commands.fillBuffer(b, 0);
  });
  CHECK(download(counters) == Words(64, 42));
  CHECK(download(b) == Words(64, 0));
  CHECK(seconds > 0.0);
}

TEST_CASE("a dispatch has the workgroups that earlier commands of its submission wrote") {
  Device device = openTestDevice();
  constexpr std::uint32_t kCount = 192;
  constexpr std::uint64_t kOffset = 8;
  const ComputePipeline pipeline = makeShift(device);
  Buffer a(device, 4 * kCount, Usage::storage);
  Buffer b(device, 4 * kCount, Usage::storage);
  Buffer groups(device, 32, Usage::storage | Usage::indirect);
  const BindingSet bindings(pipeline, {&a, &b});
  a.fill(6);
  b.fill(0);
  groups.fill(9);
  const auto countsAfter = [&](std::uint32_t groupCount) {
    const std::array<std::uint32_t, 3> written{groupCount, 1, 1};
    device.run([&](CommandRecorder& commands) {
      commands.updateBuffer(groups, kOffset, std::as_bytes(std::span(written)));
      commands.dispatchIndirect(pipeline, bindings, {}, groups, kOffset);
    });
    return download(b);
  };
  CHECK(countsAfter(0) == Words(kCount, 0));
  Words expected(kCount, 7);
  std::fill(expected.begin() + 128, expected.end(), 0);
  CHECK(countsAfter(2) == expected);
  CHECK(download(groups) == Words{9, 9, 2, 1, 1, 9, 9, 9});
}

TEST_CASE("a binding set keeps its buffers and its pipeline alive") {
  Device device = openTestDevice();
  Buffer result(device, 256, Usage::storage);
  const ComputePipeline pipeline = makeShift(device);
  const BindingSet bindings = [&] {
    Buffer source(device, 256, Usage::storage);
    source.fill(1);
    return BindingSet(makeShift(device), {&source, &result});
  }();
  device.run([&](CommandRecorder& commands) { commands.dispatch(pipeline, bindings, {}, {}); });
  CHECK(download(result) == Words(64, 2));
}

TEST_CASE("a failed recording leaves the device ready for the next") {
  Device device = openTestDevice();
  Buffer buffer(device, 64, Usage::storage);
  CHECK_THROWS_AS(device.run([&](CommandRecorder& commands) {
    commands.fillBuffer(buffer, 1);
    throw UsageError("changed my mind");
  }),
                  UsageError);
  buffer.fill(2);
  CHECK(download(buffer) == Words(16, 2));
}

TEST_CASE("arguments that do not fit a pipeline are refused before the driver is called") {
  Device device = openTestDevice();
  const ComputePipeline pipeline = makeShift(device);
  Buffer storage(device, 256, Usage::storage);
  Buffer uniform(device, 256, Usage::uniform);
  CHECK_THROWS_AS(BindingSet(pipeline, {&storage}), InternalError);
  CHECK_THROWS_AS(BindingSet(pipeline, {&storage, &uniform}), InternalError);
  const BindingSet bindings(pipeline, {&storage, &storage});
  const std::array<std::byte, 4> push{};
  const auto dispatch = [&](std::span<const std::byte> constants, vulkan::GroupCount groups) {
    device.run([&](CommandRecorder& commands) { commands.dispatch(pipeline, bindings, constants, groups); });
  };
  CHECK_THROWS_AS(dispatch(push, {}), InternalError);
  CHECK_THROWS_AS(dispatch({}, {.x = 0}), InternalError);
  CHECK_THROWS_AS(dispatch({}, {.y = 0xffffffffu}), InternalError);
  Buffer groups(device, 16, Usage::storage | Usage::indirect);
  const auto dispatchIndirect = [&](std::uint64_t offset) {
    device.run([&](CommandRecorder& commands) { commands.dispatchIndirect(pipeline, bindings, {}, groups, offset); });
  };
  CHECK_THROWS_AS(dispatchIndirect(8), InternalError);
  CHECK_THROWS_AS(dispatchIndirect(2), InternalError);
}
