// The table of memory: atomic operations, shared memory, barriers, aliasing; and the cases with more than one dispatch.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/drivers/conformance/bounds_run.h"
#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/control_twins.h"
#include "host/drivers/conformance/dispatch_runs.h"
#include "host/drivers/conformance/memory_run.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

using Span = std::span<const std::uint32_t>;

constexpr std::uint32_t kGroup = 64;
constexpr std::uint32_t kInvocations = 4096;
constexpr std::uint32_t kAllBits = 0xffffffffu;

// Every invocation of a slot gets its own position.
void checkPositions(const MemoryRow& row, Span data, Span outputs, Mismatches& mismatches) {
  for (std::uint32_t slot = 0; slot < row.parameter; ++slot) {
    WordList taken;
    for (std::uint32_t i = slot; i < row.invocations; i += row.parameter) taken.push_back(outputs[i]);
    std::ranges::sort(taken);
    mismatches.expect(fmt::format("counter {}", slot), {kMemoryData, slot}, static_cast<std::uint32_t>(taken.size()),
                      data[slot]);
    for (std::uint32_t k = 0; k < taken.size(); ++k) {
      mismatches.expect(fmt::format("position {} of counter {}, sorted", k, slot), k, taken[k]);
    }
  }
}

void checkBits(const MemoryRow& row, Span data, Span, Mismatches& mismatches) {
  std::array<std::uint32_t, 6> expected{0, kAllBits, 0, kAllBits, 0, 0};
  for (std::uint32_t i = 0; i < row.invocations; ++i) {
    const std::uint32_t word = nextWord(i);
    expected[0] |= (1u << word % 32) & 0x2d5b6a97u;
    expected[1] &= ~((1u << i % 32) & 0x1badcafeu);
    expected[2] ^= word;
    expected[3] = std::min(expected[3], word);
    expected[4] = std::max(expected[4], word);
    expected[5] += word;
  }
  constexpr std::array kNames{"atomicOr", "atomicAnd", "atomicXor", "atomicMin", "atomicMax", "atomicAdd"};
  for (std::uint32_t k = 0; k < expected.size(); ++k) {
    mismatches.expect(kNames[k], {kMemoryData, k}, expected[k], data[k]);
  }
}

// The exchanged values and the remaining one are the stored values and the first word.
void checkExchanged(const MemoryRow& row, Span data, Span outputs, Mismatches& mismatches) {
  for (std::uint32_t slot = 0; slot < row.parameter; ++slot) {
    WordList stored{0}, seen{data[slot]};
    for (std::uint32_t i = slot; i < row.invocations; i += row.parameter) {
      stored.push_back(i + 1);
      seen.push_back(outputs[i]);
    }
    std::ranges::sort(seen);
    for (std::size_t k = 0; k < stored.size(); ++k) {
      mismatches.expect(fmt::format("value {} of slot {}, sorted", k, slot), stored[k], seen[k]);
    }
  }
}

void checkSwapped(const MemoryRow& row, Span data, Span outputs, Mismatches& mismatches) {
  WordList sums(row.parameter, 0);
  for (std::uint32_t i = 0; i < row.invocations; ++i) {
    sums[i % row.parameter] += nextWord(i);
    mismatches.expect(fmt::format("invocation {} succeeds", i), {kMemoryOutputs, i}, 1, outputs[i]);
  }
  for (std::uint32_t slot = 0; slot < row.parameter; ++slot) {
    mismatches.expect(fmt::format("sum {}", slot), {kMemoryData, slot}, sums[slot], data[slot]);
  }
}

void checkScan(const MemoryRow& row, Span, Span outputs, Mismatches& mismatches) {
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < row.invocations; ++i) {
    sum = (i % kGroup == 0 ? 0 : sum) + nextWord(i) / 256;
    mismatches.expect(fmt::format("prefix sum of invocation {} (local {})", i, i % kGroup), {kMemoryOutputs, i}, sum,
                      outputs[i]);
  }
}

void checkList(const MemoryRow& row, Span, Span outputs, Mismatches& mismatches) {
  for (std::uint32_t first = 0; first < row.invocations; first += kGroup) {
    std::uint32_t sum = 0, count = 0;
    for (std::uint32_t i = first; i < first + kGroup; ++i) {
      if ((nextWord(i) >> 20) % 2 == 0) continue;
      sum += i;
      ++count;
    }
    mismatches.expect(fmt::format("sum of the list of workgroup {}", first / kGroup), {kMemoryOutputs, first}, sum,
                      outputs[first]);
    mismatches.expect(fmt::format("length of the list of workgroup {}", first / kGroup), {kMemoryOutputs, first + 1},
                      count, outputs[first + 1]);
  }
}

void checkStorageBarrier(const MemoryRow& row, Span, Span outputs, Mismatches& mismatches) {
  for (std::uint32_t first = 0; first < row.invocations; first += kGroup) {
    WordList words;
    for (std::uint32_t i = first; i < first + kGroup; ++i) words.push_back(nextWord(i));
    for (std::uint32_t iteration = 0; iteration < 8; ++iteration) {
      const WordList before = words;
      for (std::uint32_t k = 0; k < kGroup; ++k) words[k] = nextWord(before[k] ^ before[(5 * k + iteration) % kGroup]);
    }
    for (std::uint32_t k = 0; k < kGroup; ++k) {
      mismatches.expect(fmt::format("invocation {} of workgroup {}", k, first / kGroup), {kMemoryOutputs, first + k},
                        words[k], outputs[first + k]);
    }
  }
}

void checkAliased(const MemoryRow& row, Span data, Span outputs, Mismatches& mismatches) {
  for (std::uint32_t i = 0; i < row.invocations; ++i) {
    const std::uint32_t a = (nextWord(i) >> 20) % 8, b = (nextWord(nextWord(i)) >> 20) % 8;
    const std::uint32_t seen = a == b ? i + 7 : i;
    const std::uint32_t second = a == b ? 3 * seen : i + 7;
    mismatches.expect(fmt::format("invocation {} with indices {} and {}", i, a, b), {kMemoryOutputs, i},
                      second + 5 * seen, outputs[i]);
    mismatches.expect(fmt::format("word {} of invocation {}", a, i), {kMemoryData, 8 * i + a}, 3 * seen,
                      data[8 * i + a]);
  }
}

const std::array<MemoryRow, 8>& memoryRows() {
  static const std::array<MemoryRow, 8> rows{
      {{"atomic.positions", 0, kInvocations, 13, 16, {}, checkPositions},
       {"atomic.combine", 1, kInvocations, 0, 16, {0, kAllBits, 0, kAllBits, 0, 0}, checkBits},
       {"atomic.exchange", 2, kInvocations, 5, 16, {}, checkExchanged},
       {"atomic.compare_swap", 3, kInvocations, 48, 64, {}, checkSwapped},
       {"shared.scan", 4, kInvocations, 0, 16, {}, checkScan},
       {"shared.list", 5, kInvocations, 0, 16, {}, checkList},
       {"storage.barrier", 6, kInvocations, 0, kInvocations, {}, checkStorageBarrier},
       {"storage.aliasing", 7, kInvocations, 0, 8 * kInvocations, {}, checkAliased}}};
  return rows;
}

}  // namespace

Cases memoryCases() {
  constexpr const char* kChild = "memory";
  Cases cases;
  for (const MemoryRow& row : memoryRows()) {
    cases.push_back(caseOf(fmt::format("memory.{}", row.name), kChild, memoryPipeline(row.function),
                           [&row](Workbench& workbench) { return runMemory(row, workbench.device()); }));
  }
  const auto add = [&](const char* name, CasePipeline pipeline, Finding (*run)(vulkan::Device&)) {
    cases.push_back(
        caseOf(name, kChild, std::move(pipeline), [run](Workbench& workbench) { return run(workbench.device()); }));
  };
  add("memory.storage.records", recordsPipeline(), runRecords);
  add("memory.dispatch.chain", chainPipeline(), runChain);
  add("memory.dispatch.queue", queuePipeline(), runQueue);
  cases.push_back({"memory.command.copy", kChild, [](Workbench& workbench) { return runCopies(workbench.device()); }});
  for (const BoundsRow& row : boundsRows()) {
    cases.push_back({fmt::format("memory.robust.{}", row.name), "memory.robust",
                     [&row](Workbench& workbench) { return runBounds(row, workbench); },
                     [&row](Workbench& workbench) { return compileBounds(row, workbench); }});
  }
  return cases;
}

}  // namespace candela::conformance
