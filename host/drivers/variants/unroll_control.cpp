// Sets the loop control.
#include "host/drivers/variants/unroll_control.h"

#include "host/drivers/variants/opcodes.h"

namespace candela::variants {

std::size_t requestUnrolling(Module& module) {
  constexpr std::size_t kControl = 3;
  std::size_t count = 0;
  for (Instruction& one : module.instructions) {
    if (one.opcode != kOpLoopMerge) continue;
    one.words[kControl] = (one.words[kControl] & ~kLoopDontUnroll) | kLoopUnroll;
    ++count;
  }
  return count;
}

}  // namespace candela::variants
