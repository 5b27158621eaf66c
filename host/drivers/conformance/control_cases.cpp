// The table of control flow.
#include <fmt/format.h>

#include <array>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/control_run.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

constexpr std::uint32_t kLongLoop = 1u << 20;
constexpr std::uint32_t kHalfLoop = 40'000;  // two of them exceed 16 bits
constexpr std::uint32_t kNestedLoop = 300;   // its square exceeds 16 bits

const std::array<ControlRow, 14> kControlRows{{{"loop.iterations", 0, countOneLoop, kLongLoop, 8},
                                               {"loop.iterations_of_two_loops", 1, countTwoLoops, kHalfLoop, 8},
                                               {"loop.iterations_of_nested_loops", 2, countNestedLoops, kNestedLoop, 8},
                                               {"loop.ended_in_the_middle", 3, endInTheMiddle},
                                               {"loop.ended_at_the_end", 4, endAtTheEnd},
                                               {"loop.values_after_break", 5, valuesAfterBreak},
                                               {"loop.nested_break", 6, nestedBreak},
                                               {"loop.continue", 7, continued},
                                               {"loop.return", 8, returned},
                                               {"switch.in_loop", 9, switched},
                                               {"stack.tree", 10, treeOnStack},
                                               {"stack.deep", 11, deepStack},
                                               {"function.inout", 12, copiedInAndOut},
                                               {"function.short_circuit", 13, shortCircuit}}};

}  // namespace

Cases controlCases() {
  Cases cases;
  for (const ControlRow& row : kControlRows) {
    cases.push_back(caseOf(fmt::format("control.{}", row.name), "control", pipelineOf(row),
                           [row](Workbench& workbench) { return runControl(row, workbench.device()); }));
  }
  return cases;
}

}  // namespace candela::conformance
