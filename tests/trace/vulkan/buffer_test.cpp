// Buffers return the data that were written to them, by every way of writing and reading, and respect limits.
#include "host/trace/vulkan/buffer.h"

#include <catch2/catch.hpp>
#include <cstring>

#include "host/base/errors.h"
#include "tests/trace/vulkan/test_words.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::vulkan;
using Catch::Matchers::Contains;
using vulkan::Buffer;
using vulkan::CommandRecorder;
using vulkan::Device;
using vulkan::Usage;

namespace {

constexpr std::size_t kStagingBytes = 4096;

/// The two kinds of access to device memory: mapped where the device allows it, and through a small staging buffer.
Device openEitherWay(bool throughStaging) {
  return openTestDevice({.stagingBytes = kStagingBytes, .mapDeviceMemory = !throughStaging});
}

}  // namespace

TEST_CASE("a buffer of any size returns the data that were written") {
  Device device = openEitherWay(GENERATE(false, true));
  for (const std::size_t bytes : {std::size_t{4}, std::size_t{16}, kStagingBytes - 4, kStagingBytes, kStagingBytes + 4,
                                  3 * kStagingBytes, 37 * kStagingBytes + 20}) {
    Buffer buffer(device, bytes, Usage::storage);
    const Words words = makeWords(bytes / 4);
    upload(buffer, words);
    CHECK(download(buffer) == words);
  }
}

TEST_CASE("a part of a buffer can be written and read separately") {
  Device device = openEitherWay(GENERATE(false, true));
  Buffer buffer(device, 10 * kStagingBytes, Usage::storage);
  Words expected = makeWords(10 * kStagingBytes / 4);
  upload(buffer, expected);
  const Words part = makeWords(3 * kStagingBytes / 4 + 5, 77);
  upload(buffer, part, 1000);
  std::copy(part.begin(), part.end(), expected.begin() + 250);
  CHECK(download(buffer) == expected);

  Words middle(2 * kStagingBytes / 4 + 1);
  buffer.download(std::as_writable_bytes(std::span(middle)), 5000);
  CHECK(std::equal(middle.begin(), middle.end(), expected.begin() + 1250));
}

TEST_CASE("memory is not mapped if mapping is turned off") {
  Device device = openEitherWay(true);
  CHECK_FALSE(Buffer(device, 64, Usage::storage).isMapped());
}

TEST_CASE("fill sets every word") {
  Device device = openEitherWay(GENERATE(false, true));
  Buffer buffer(device, 4 * 1001, Usage::storage);
  buffer.fill(0xdeadbeefu);
  CHECK(download(buffer) == Words(1001, 0xdeadbeefu));
}

TEST_CASE("a recorded copy moves the given range, in order with fills") {
  Device device = openEitherWay(GENERATE(false, true));
  Buffer from(device, 64, Usage::storage);
  Buffer to(device, 64, Usage::storage);
  const Words words = makeWords(16);
  upload(from, words);
  device.run([&](CommandRecorder& commands) {
    commands.fillBuffer(to, 7);
    commands.copyBuffer(from, 8, to, 16, 12);
    commands.fillBuffer(to, 9, 20, 4);
  });
  Words expected(16, 7);
  expected[4] = words[2];
  expected[5] = 9;
  expected[6] = words[4];
  CHECK(download(to) == expected);
}

TEST_CASE("the mapping of a readback buffer contains what the device wrote") {
  Device device = openEitherWay(GENERATE(false, true));
  Buffer counters(device, 16, Usage::storage | Usage::readback);
  REQUIRE(counters.isMapped());
  for (const std::uint32_t value : {3u, 4u, 5u}) {
    device.run([&](CommandRecorder& commands) { commands.fillBuffer(counters, value); });
    std::uint32_t last = 0;
    std::memcpy(&last, counters.mapped().data() + 12, 4);
    CHECK(last == value);
  }
}

TEST_CASE("ranges outside of a buffer or not aligned to words are refused") {
  Device device = openTestDevice();
  Buffer buffer(device, 64, Usage::storage);
  CHECK_THROWS_AS(upload(buffer, Words(1), 64), InternalError);
  CHECK_THROWS_AS(upload(buffer, Words(17)), InternalError);
  CHECK_THROWS_AS(upload(buffer, Words(1), ~std::uint64_t{3}), InternalError);
  CHECK_THROWS_AS(upload(buffer, Words(1), 2), InternalError);
  CHECK_THROWS_AS(buffer.mapped(), InternalError);
  CHECK_THROWS_AS(Buffer(device, 0, Usage::storage), InternalError);
  CHECK_THROWS_AS(Buffer(device, 6, Usage::storage), InternalError);
  CHECK_THROWS_AS(Buffer(device, 20, Usage::uniformTexel), InternalError);
}

TEST_CASE("a size beyond the device's limits is an out-of-memory error that names it") {
  Device device = openTestDevice();
  constexpr std::uint64_t kAbsurd = std::uint64_t{1} << 44;
  CHECK_THROWS_AS(Buffer(device, kAbsurd, Usage::storage), OutOfMemoryError);
  CHECK_THROWS_AS(Buffer(device, kAbsurd, Usage::uniformTexel), OutOfMemoryError);
  CHECK_THROWS_AS(Buffer(device, kAbsurd, Usage::uniform), OutOfMemoryError);
  CHECK_THROWS_WITH(Buffer(device, kAbsurd, Usage::storage), Contains("17592186044416 bytes"));
  CHECK_THROWS_AS(Buffer(device, device.info().maxTexelBufferElements * 16 + 16, Usage::uniformTexel),
                  OutOfMemoryError);
}

TEST_CASE("a buffer larger than any heap is an out-of-memory error that names it") {
  Device device = openTestDevice();
  CHECK_THROWS_AS(Buffer(device, std::uint64_t{1} << 44, Usage::readback), OutOfMemoryError);
  CHECK_THROWS_WITH(Buffer(device, std::uint64_t{1} << 44, Usage::readback), Contains("17592186044416 bytes"));
  CHECK(device.memoryUse().currentBytes == 0);
}

TEST_CASE("the device counts the current and the maximum bytes of buffers") {
  Device device = openTestDevice();
  {
    const Buffer a(device, 1000, Usage::storage);
    const Buffer b(device, 500, Usage::storage);
    CHECK(device.memoryUse().currentBytes == 1500);
  }
  const Buffer c(device, 100, Usage::storage);
  CHECK(device.memoryUse().currentBytes == 100);
  CHECK(device.memoryUse().peakBytes == 1500);
}

TEST_CASE("freed buffers in system memory no longer count") {
  MemoryTally tally;
  tally.add(300, true);
  tally.add(70, false);
  CHECK(tally.use().systemBytes == 300);
  tally.remove(300, true);
  tally.add(40, true);
  CHECK(tally.use().systemBytes == 40);
  CHECK(tally.use().currentBytes == 110);
  CHECK(tally.use().peakBytes == 370);
}

TEST_CASE("a buffer outlives the handle of its device") {
  const Buffer buffer = [] {
    Device device = openTestDevice();
    Buffer made(device, 64, Usage::storage);
    made.fill(5);
    return made;
  }();
  CHECK(download(buffer) == Words(16, 5));
}
