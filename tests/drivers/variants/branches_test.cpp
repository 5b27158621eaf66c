// The branches of kernels, which SwiftShader searches: docs/driver-workarounds.md section 15.
#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>
#include <map>

#include "host/drivers/variants/opcodes.h"
#include "host/drivers/variants/passes.h"
#include "spirv/cast_rays.h"
#include "spirv/replay.h"
#include "spirv/wave_shadow.h"
#include "tests/drivers/variants/modules.h"

namespace candela::variants {
namespace {

constexpr double kMaxEntries = 1 << 20;

struct Block {
  std::vector<std::uint32_t> successors;
  std::uint32_t loopMerge = 0;  // label of the block after the loop that this block is the header of; 0: of none
};

using Blocks = std::map<std::uint32_t, Block>;

std::vector<std::uint32_t> targetsOf(const Instruction& branch) {
  std::vector<std::uint32_t> ids;
  for (const std::uint16_t index : branch.idIndices) ids.push_back(branch.words[index]);
  if (branch.opcode != kOpBranch) ids.erase(ids.begin());  // the condition or the selector
  if (ids.size() == 2 && ids[0] == ids[1]) ids.pop_back();
  return ids;
}

Blocks blocksOf(const Module& module) {
  Blocks blocks;
  Block* block = nullptr;
  for (const Instruction& instruction : module.instructions) {
    switch (instruction.opcode) {
      case kOpLabel:
        block = &blocks[instruction.result];
        break;
      case kOpLoopMerge:
        block->loopMerge = instruction.words[1];
        break;
      case kOpBranch:
      case kOpBranchConditional:
      case kOpSwitch:
        block->successors = targetsOf(instruction);
        break;
      default:
        break;
    }
  }
  return blocks;
}

/// Returns the number of entries of the queue in which SwiftShader searches the body of a loop from its header: the
/// sum, over all blocks of the body, of the number of shortest paths to the block.
double queueEntries(const Blocks& blocks, std::uint32_t header) {
  struct Reached {
    std::size_t distance = 0;
    double paths = 0;
  };
  const std::uint32_t end = blocks.at(header).loopMerge;
  std::map<std::uint32_t, Reached> reached{{header, {0, 1}}};
  std::deque<std::uint32_t> pending{header};
  double entries = 0;
  for (; !pending.empty(); pending.pop_front()) {
    const Reached from = reached.at(pending.front());
    entries += from.paths;
    for (const std::uint32_t next : blocks.at(pending.front()).successors) {
      if (next == end) continue;
      const auto [found, isNew] = reached.try_emplace(next, Reached{from.distance + 1, 0});
      if (isNew) pending.push_back(next);
      if (found->second.distance == from.distance + 1) found->second.paths += from.paths;
    }
  }
  return entries;
}

double mostEntries(const Blocks& blocks) {
  double most = 0;
  for (const auto& [label, block] : blocks) {
    if (block.loopMerge != 0) most = std::max(most, queueEntries(blocks, label));
  }
  return most;
}

}  // namespace

TEST_CASE("branches: selections of two blocks double the queue, and selections of one do not") {
  // Block 100 is after the loop.
  const Blocks two{{1, {{2, 3}, 100}}, {2, {{4}}}, {3, {{4}}}, {4, {{5, 6}}}, {5, {{7}}}, {6, {{7}}}, {7, {{1, 100}}}};
  CHECK(mostEntries(two) == 1 + 2 + 2 + 4 + 4);
  const Blocks one{{1, {{2, 3}, 100}}, {2, {{3}}}, {3, {{4, 5}}}, {4, {{5}}}, {5, {{1, 100}}}};
  CHECK(mostEntries(one) == 5);
}

TEST_CASE("branches: SwiftShader can search every kernel, with all features", "[slow]") {
  const std::vector<NamedModule> modules{{"path", spirv::path},
                                         {"replay", spirv::replay},
                                         {"views", spirv::views},
                                         {"whitted", spirv::whitted},
                                         {"wave_extend", spirv::wave_extend},
                                         {"wave_shade", spirv::wave_shade},
                                         {"wave_shadow", spirv::wave_shadow},
                                         {"cast_rays", spirv::cast_rays}};
  for (const NamedModule& module : modules) {
    INFO(module.name);
    const Code code = optimised(vulkan::reducedSpirv(module.spirv, {}), performancePasses());
    const double entries = mostEntries(blocksOf(parseModule(code)));
    INFO(entries);
    CHECK(entries > 1);
    CHECK(entries <= kMaxEntries);
  }
}

}  // namespace candela::variants
