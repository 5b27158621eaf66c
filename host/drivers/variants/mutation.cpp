// Chooses the kind and the place of a mutation.
#include "host/drivers/variants/mutation.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host/drivers/variants/mutation_kinds.h"

namespace candela::variants {
namespace {

using Ids = std::set<std::uint32_t>;

// Labels of the blocks that must not be changed, because a loop needs them.
Ids continueTargets(const Module& module) {
  Ids targets;
  for (const Instruction& one : module.instructions) {
    if (one.opcode == kOpLoopMerge) targets.insert(one.words[2]);
  }
  return targets;
}

bool canBeAnchor(const Instruction& one) {
  return one.result != 0 && one.type != 0 && one.opcode != kOpPhi && one.opcode != kOpVariable;
}

// Takes the results of one block from `begin` on, and returns the index after its end. A loop header is omitted,
// since the end of a loop branches to it.
std::size_t takeBlock(const std::vector<Instruction>& code, std::size_t begin, const Ids& excluded,
                      std::vector<Anchor>& anchors) {
  std::vector<Anchor> found;
  bool isHeader = false;
  std::size_t i = begin + 1;
  for (; i < code.size() && code[i].opcode != kOpLabel && code[i].opcode != kOpFunctionEnd; ++i) {
    isHeader = isHeader || code[i].opcode == kOpLoopMerge;
    if (canBeAnchor(code[i])) found.push_back({code[i].result, code[i].opcode, code[i].type});
  }
  if (!isHeader && !excluded.contains(code[begin].result)) anchors.insert(anchors.end(), found.begin(), found.end());
  return i;
}

std::vector<Anchor> anchorsOf(const Module& module) {
  const Ids excluded = continueTargets(module);
  std::vector<Anchor> anchors;
  for (std::size_t i = 0; i < module.instructions.size();) {
    const bool isBlock = module.instructions[i].opcode == kOpLabel;
    i = isBlock ? takeBlock(module.instructions, i, excluded, anchors) : i + 1;
  }
  return anchors;
}

std::mt19937 randomOf(const Mutation& mutation) {
  return std::mt19937(mutation.seed * 0x9e3779b9u + mutation.index * 0x85ebca6bu);
}

}  // namespace

const std::array<MutationKind, 7>& mutationKinds() {
  static constexpr std::array<MutationKind, 7> kKinds{
      {{"divided block", isPossibleAnywhere, splitAtAnchor},
       {"dead branch", isPossibleAnywhere, addDeadBranch},
       {"branch without effect", isPossibleAnywhere, addBranchWithoutEffect},
       {"loop of one iteration", isPossibleAnywhere, wrapInLoop},
       {"selection", isScalarOrVector, selectResult},
       {"copy", isScalarOrVector, copyResult},
       {"exchanged operands", isCommutative, exchangeOperands}}};
  return kKinds;
}

Mutator::Mutator(Module& module) : editor_(module), anchors_(anchorsOf(module)) {}

std::string Mutator::apply(const Mutation& mutation) {
  std::mt19937 random = randomOf(mutation);
  const MutationKind& kind = mutationKinds()[random() % mutationKinds().size()];
  std::vector<Anchor> possible;
  std::ranges::copy_if(anchors_, std::back_inserter(possible),
                       [&](const Anchor& anchor) { return kind.isPossible(editor_, anchor); });
  if (possible.empty()) return {};
  const Anchor& anchor = possible[random() % possible.size()];
  kind.apply(editor_, anchor, random);
  return fmt::format("{} at %{}", kind.name, anchor.result);
}

}  // namespace candela::variants
