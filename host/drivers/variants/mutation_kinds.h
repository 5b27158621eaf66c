// The kinds of mutations.
#pragma once
#include "host/drivers/variants/mutation.h"

namespace candela::variants {

bool isPossibleAnywhere(const Editor& editor, const Anchor& anchor);

/// Divides the anchor's block before it.
void splitAtAnchor(Editor& editor, const Anchor& anchor, std::mt19937& random);
/// Inserts a branch that is never taken, to a block that repeats arithmetic and overwrites a local variable.
void addDeadBranch(Editor& editor, const Anchor& anchor, std::mt19937& random);
/// Inserts a branch that depends on the invocation, to two blocks without effects. A value goes through both.
void addBranchWithoutEffect(Editor& editor, const Anchor& anchor, std::mt19937& random);
/// Moves the anchor and up to seven instructions after it into a loop of one iteration.
void wrapInLoop(Editor& editor, const Anchor& anchor, std::mt19937& random);

bool isScalarOrVector(const Editor& editor, const Anchor& anchor);
bool isCommutative(const Editor& editor, const Anchor& anchor);

/// Replaces the result by a selection between it and zero, whose condition is always true.
void selectResult(Editor& editor, const Anchor& anchor, std::mt19937& random);
/// Replaces the result by a copy.
void copyResult(Editor& editor, const Anchor& anchor, std::mt19937& random);
/// Exchanges the operands of a commutative operation, or of a comparison, which becomes the opposite one.
void exchangeOperands(Editor& editor, const Anchor& anchor, std::mt19937& random);

/// Returns the computation of a bool with this value, which a compiler may or may not see through.
Computation condition(Editor& editor, bool value, std::mt19937& random);

}  // namespace candela::variants
