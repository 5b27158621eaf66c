// The table of variants.
#include <fmt/format.h>

#include "host/drivers/variants/passes.h"
#include "host/drivers/variants/variant.h"

namespace candela::variants {
namespace {

constexpr std::uint32_t kSeeds = 4, kMutations = 64;

using Steps = std::vector<Step>;

Steps stepsOf(const std::vector<std::string>& passes) {
  Steps steps;
  for (const std::string& pass : passes) steps.push_back({StepKind::pass, pass});
  return steps;
}

// The optimiser inlines functions that return at their end, and unrolls loops over values rather than variables.
Steps inlining() { return stepsOf({"merge-return", "inline-entry-points-exhaustive", "eliminate-dead-functions"}); }

Steps unrolling() {
  Steps steps = stepsOf({"ssa-rewrite", "ccp", "loop-unroll"});
  steps.insert(steps.begin(), {StepKind::requestUnrolling});
  return steps;
}

Steps mutations(std::uint32_t seed) {
  Steps steps;
  for (std::uint32_t index = 0; index < kMutations; ++index) steps.push_back({StepKind::mutation, {}, {seed, index}});
  return steps;
}

Steps then(Steps first, const Steps& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<Variant> makeVariants() {
  std::vector<Variant> variants{
      {"O", stepsOf(performancePasses())}, {"Os", stepsOf(sizePasses())},     {"inlined", inlining()},
      {"unrolled", unrolling()},           {"frozen", {}, Constants::frozen}, {"open", {}, Constants::open}};
  for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
    variants.push_back({fmt::format("mutated_{}", seed), mutations(seed)});
  }
  variants.push_back({"mutated_1_O", then(mutations(1), stepsOf(performancePasses()))});
  return variants;
}

}  // namespace

Variant plainVariant() { return {"plain", {}}; }

const std::vector<Variant>& allVariants() {
  static const std::vector<Variant> variants = makeVariants();
  return variants;
}

Variant withContraction(Variant variant) {
  variant.forbidsContraction = false;
  return variant;
}

}  // namespace candela::variants
