// Several dispatches in one submission.
#include "host/drivers/conformance/dispatch_runs.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "host/base/divide_up.h"
#include "host/drivers/conformance/control_twins.h"
#include "host/drivers/conformance/memory_run.h"
#include "host/drivers/conformance/mismatches.h"
#include "host/drivers/conformance/shader_run.h"
#include "spirv/memory.h"
#include "spirv/queue.h"
#include "spirv/records.h"

namespace candela::conformance {
namespace {

using vulkan::BindingKind;
using vulkan::Usage;

constexpr std::uint32_t kGroup64 = 64;
constexpr std::uint32_t kItems = 3000;
constexpr std::uint32_t kChainSteps = 24;
constexpr std::uint32_t kReadNeighbour = 8;  // kFunction of memory.comp
constexpr std::uint32_t kRounds = 20;
constexpr std::uint32_t kStates = 2;  // binding of queue.comp
constexpr std::uint64_t kHeaderBytes = 16;
constexpr std::uint32_t kPartWords = 28;
constexpr std::uint32_t kParts = 200;

WordList chainOfWords(std::uint32_t count) {
  WordList words;
  for (std::uint32_t i = 0; i < count; ++i) words.push_back(nextWord(i));
  return words;
}

// Header of an empty queue: one row of no workgroups, no entries.
constexpr std::array<std::uint32_t, 4> kEmptyHeader{0, 1, 1, 0};

/// An item's word after its last round, and the number of its rounds.
struct ItemState {
  std::uint32_t word;
  std::uint32_t rounds;
};

ItemState afterRounds(std::uint32_t word) {
  std::uint32_t rounds = 0;
  for (bool isQueued = true; isQueued && rounds < kRounds; isQueued = word >> 29 != 0) {
    word = nextWord(word);
    ++rounds;
  }
  return {word, rounds};
}

void recordRounds(vulkan::CommandRecorder& recorder, const vulkan::ComputePipeline& pipeline,
                  const vulkan::BindingSet& bindings, const vulkan::Buffer& headers) {
  for (std::uint32_t round = 0; round < kRounds; ++round) {
    const std::array<std::uint32_t, 2> push{kItems, round};
    const std::span bytes = std::as_bytes(std::span(push));
    recorder.updateBuffer(headers, kHeaderBytes * (1 - round % 2), std::as_bytes(std::span(kEmptyHeader)));
    if (round == 0) {
      recorder.dispatch(pipeline, bindings, bytes, {.x = divideUp(kItems, kGroup64)});
    } else {
      recorder.dispatchIndirect(pipeline, bindings, bytes, headers, kHeaderBytes * (round % 2));
    }
  }
}

ShaderRun recordsRun() { return {spirv::records, kParts}; }

// Indices of the words that records.comp writes, in the order of its outputs. `k` is c[0] % 3.
std::array<std::uint32_t, 16> partIndices(std::uint32_t k) {
  return {0, 1, 2, 3, 4, 5, 6, 4 + k, 8, 9, 12 + 4 * k + 2, 12 + 8 + k, 24, 25, 26, 24 + k};
}

}  // namespace

CasePipeline chainPipeline() { return memoryPipeline(kReadNeighbour); }

Finding runChain(vulkan::Device& device) {
  const std::array<std::uint32_t, 2> push{kItems, 0};
  const vulkan::ComputePipeline pipeline = create(chainPipeline(), device);
  WordList words = chainOfWords(kItems);
  vulkan::Buffer even(device, kItems * sizeof(std::uint32_t), Usage::storage);
  vulkan::Buffer odd(device, kItems * sizeof(std::uint32_t), Usage::storage);
  even.upload(std::as_bytes(std::span(words)));
  const vulkan::BindingSet forth(pipeline, {&even, &odd});
  const vulkan::BindingSet back(pipeline, {&odd, &even});
  device.run([&](vulkan::CommandRecorder& recorder) {
    for (std::uint32_t step = 0; step < kChainSteps; ++step) {
      recorder.dispatch(pipeline, step % 2 == 0 ? forth : back, std::as_bytes(std::span(push)),
                        {.x = divideUp(kItems, kGroup64)});
    }
  });
  for (std::uint32_t step = 0; step < kChainSteps; ++step) {
    const WordList before = words;
    for (std::uint32_t i = 0; i < kItems; ++i) words[i] = nextWord(before[(i + 37) % kItems]);
  }
  const WordList found = wordsOf(even);
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < kItems; ++i) {
    mismatches.expect(fmt::format("word {} after {} dispatches", i, kChainSteps), {kOutputs, i}, words[i], found[i]);
  }
  return mismatches.finding();
}

CasePipeline queuePipeline() {
  return {spirv::queue, {.bindings = {3, BindingKind::storageBuffer}, .pushConstantBytes = 8}};
}

Finding runQueue(vulkan::Device& device) {
  const vulkan::ComputePipeline pipeline = create(queuePipeline(), device);
  vulkan::Buffer headers(device, 2 * kHeaderBytes, Usage::storage | Usage::indirect);
  vulkan::Buffer queues(device, 2 * kItems * sizeof(std::uint32_t), Usage::storage);
  vulkan::Buffer states(device, 2 * kItems * sizeof(std::uint32_t), Usage::storage);
  WordList initial;
  for (std::uint32_t i = 0; i < kItems; ++i) initial.insert(initial.end(), {nextWord(i), 0});
  states.upload(std::as_bytes(std::span(initial)));
  headers.fill(0);
  queues.fill(0);
  const vulkan::BindingSet bindings(pipeline, {&headers, &queues, &states});
  device.run([&](vulkan::CommandRecorder& recorder) { recordRounds(recorder, pipeline, bindings, headers); });
  const WordList found = wordsOf(states);
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < kItems; ++i) {
    const ItemState expected = afterRounds(initial[2 * i]);
    mismatches.expect(fmt::format("item {}, rounds", i), {kStates, 2 * i + 1}, expected.rounds, found[2 * i + 1]);
    mismatches.expect(fmt::format("item {}, word", i), {kStates, 2 * i}, expected.word, found[2 * i]);
  }
  return mismatches.finding();
}

Finding runCopies(vulkan::Device& device) {
  constexpr std::uint32_t kWords = 1024;
  WordList expected = chainOfWords(kWords);
  vulkan::Buffer a(device, kWords * sizeof(std::uint32_t), Usage::storage);
  vulkan::Buffer b(device, kWords * sizeof(std::uint32_t), Usage::storage);
  a.upload(std::as_bytes(std::span(expected)));
  const std::array<std::uint32_t, 3> update{11, 22, 33};
  device.run([&](vulkan::CommandRecorder& recorder) {
    recorder.fillBuffer(b, 7);
    recorder.copyBuffer(a, 0, b, 400, 1200);                          // words 0 to 299 to 100
    recorder.updateBuffer(b, 600, std::as_bytes(std::span(update)));  // words 150 to 152
    recorder.copyBuffer(b, 400, b, 2000, 400);                        // words 100 to 199 to 500
    recorder.fillBuffer(b, 9, 2040, 8);                               // words 510 and 511
    recorder.copyBuffer(b, 0, a, 0, kWords * sizeof(std::uint32_t));
  });
  WordList copied(kWords, 7);
  std::copy_n(expected.begin(), 300, copied.begin() + 100);
  std::ranges::copy(update, copied.begin() + 150);
  std::copy_n(copied.begin() + 100, 100, copied.begin() + 500);
  copied[510] = copied[511] = 9;
  const WordList found = wordsOf(a);
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < kWords; ++i) mismatches.expect(fmt::format("word {}", i), copied[i], found[i]);
  return mismatches.finding();
}

CasePipeline recordsPipeline() { return pipelineOf(recordsRun()); }

Finding runRecords(vulkan::Device& device) {
  const WordList words = chainOfWords(kParts * kPartWords);
  // The words of floats are between 1 and 2, since a device may change the bits of denormal numbers and NaNs.
  WordList parts = words;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t member = i % kPartWords;
    const bool isFloat = member < 4 || (member >= 8 && member < 24);
    if (isFloat) parts[i] = 0x3f800000u | (words[i] >> 9);
  }
  const WordList found = runShader<std::uint32_t>(device, recordsRun(), parts, std::size_t{16} * kParts);
  Mismatches mismatches;
  for (std::uint32_t part = 0; part < kParts; ++part) {
    const std::uint32_t* const first = &parts[part * kPartWords];
    const std::array<std::uint32_t, 16> indices = partIndices(first[4] % 3);
    for (std::uint32_t k = 0; k < indices.size(); ++k) {
      mismatches.expect(fmt::format("record {}, word {} (output {})", part, indices[k], k), {kOutputs, 16 * part + k},
                        first[indices[k]], found[16 * part + k]);
    }
  }
  return mismatches.finding();
}

}  // namespace candela::conformance
