// Changes of a module that preserve its results, chosen by a seed: dead code, branches without effect, and others that
// a compiler must see through. The idea is that of GraphicsFuzz (Donaldson, Evrard, Lascu and Thomson, Automated
// Testing of Graphics Shader Compilers, OOPSLA 2017).
#pragma once
#include <array>
#include <random>
#include <string>
#include <string_view>

#include "host/drivers/variants/editor.h"

namespace candela::variants {

/// The mutation number `index` of a seed.
struct Mutation {
  std::uint32_t seed = 0;
  std::uint32_t index = 0;
  bool operator==(const Mutation&) const = default;
};

/// The instruction of the original module next to which a mutation takes place.
struct Anchor {
  std::uint32_t result = 0;
  std::uint32_t opcode = 0;
  std::uint32_t type = 0;
};

/// A kind of mutation.
struct MutationKind {
  std::string_view name;
  bool (*isPossible)(const Editor& editor, const Anchor& anchor);
  void (*apply)(Editor& editor, const Anchor& anchor, std::mt19937& random);
};

/// Returns all kinds: branch_mutations.cpp and value_mutations.cpp.
const std::array<MutationKind, 7>& mutationKinds();

/// Applies mutations of one module. Their anchors do not change if some of them are omitted.
class Mutator {
 public:
  /// `module` is the original one.
  explicit Mutator(Module& module);
  /// Returns a description of the change, e.g. "dead branch before %123"; empty if the module has no place for the
  /// mutation.
  std::string apply(const Mutation& mutation);

 private:
  Editor editor_;
  std::vector<Anchor> anchors_;
};

}  // namespace candela::variants
