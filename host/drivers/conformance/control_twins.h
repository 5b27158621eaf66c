// Counterparts on the host of the functions of shaders/conformance/control.comp.
#pragma once
#include <cstdint>

#include "host/drivers/conformance/shader_run.h"

namespace candela::conformance {

/// A function of one invocation's word, and of the push constant that is common to all.
using ControlTwin = Words (*)(std::uint32_t state, std::uint32_t parameter);

Words countOneLoop(std::uint32_t state, std::uint32_t iterations);
Words countTwoLoops(std::uint32_t state, std::uint32_t iterations);
Words countNestedLoops(std::uint32_t state, std::uint32_t iterations);
Words endInTheMiddle(std::uint32_t state, std::uint32_t);
Words endAtTheEnd(std::uint32_t state, std::uint32_t);
Words valuesAfterBreak(std::uint32_t state, std::uint32_t);
Words nestedBreak(std::uint32_t state, std::uint32_t);
Words continued(std::uint32_t state, std::uint32_t);
Words returned(std::uint32_t state, std::uint32_t);
Words switched(std::uint32_t state, std::uint32_t);
Words treeOnStack(std::uint32_t seed, std::uint32_t);
Words deepStack(std::uint32_t state, std::uint32_t);
Words copiedInAndOut(std::uint32_t state, std::uint32_t);
Words shortCircuit(std::uint32_t state, std::uint32_t);

/// The chain of the shaders: the word after `state`.
std::uint32_t nextWord(std::uint32_t state);

}  // namespace candela::conformance
