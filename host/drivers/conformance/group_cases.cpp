// The tables of workgroups and of subgroup sizes.
#include <fmt/format.h>

#include <array>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/control_run.h"
#include "host/drivers/conformance/identity_run.h"
#include "host/drivers/conformance/workbench.h"

namespace candela::conformance {
namespace {

constexpr std::array<GroupShape, 7> kGroupShapes{
    {{1, 1, 1}, {64, 1, 1}, {8, 8, 1}, {4, 4, 4}, {3, 5, 2}, {1, 1, 37}, {256, 2, 1}}};
constexpr GroupShape kSubgroupShape{64, 1, 1};

/// Control flow whose result must not depend on how many invocations diverge together.
const std::array<ControlRow, 4> kSubgroupControl{{{"loop.ended_at_the_end", 4, endAtTheEnd},
                                                  {"loop.nested_break", 6, nestedBreak},
                                                  {"switch.in_loop", 9, switched},
                                                  {"stack.deep", 11, deepStack}}};

Finding runShape(const GroupShape& shape, Workbench& workbench) {
  if (!hasShape(workbench.info(), shape)) return skipped(missingShape(workbench.info(), shape));
  return runIdentities(shape, workbench.device(), workbench.info().subgroupSize);
}

Finding runSubgroup(std::uint32_t size, const Workbench& workbench) {
  if (!hasSubgroupSize(workbench.info(), size)) return skipped(missingSubgroupSize(workbench.info(), size));
  vulkan::Device device = workbench.open({.subgroupSize = size});
  if (Finding finding = runIdentities(kSubgroupShape, device, size); finding.outcome != Outcome::pass) return finding;
  for (const ControlRow& row : kSubgroupControl) {
    if (Finding finding = runControl(row, device); finding.outcome != Outcome::pass) return finding;
  }
  return passed();
}

Finding compileShape(const GroupShape& shape, Workbench& workbench) {
  if (!hasShape(workbench.info(), shape)) return skipped(missingShape(workbench.info(), shape));
  create(pipelineOf(shape), workbench.device());
  return passed();
}

Finding compileSubgroup(std::uint32_t size, const Workbench& workbench) {
  if (!hasSubgroupSize(workbench.info(), size)) return skipped(missingSubgroupSize(workbench.info(), size));
  vulkan::Device device = workbench.open({.subgroupSize = size});
  create(pipelineOf(kSubgroupShape), device);
  for (const ControlRow& row : kSubgroupControl) create(pipelineOf(row), device);
  return passed();
}

}  // namespace

Cases groupCases() {
  constexpr const char* kChild = "group";
  Cases cases;
  for (const GroupShape& shape : kGroupShapes) {
    cases.push_back({fmt::format("group.size.{}x{}x{}", shape.x, shape.y, shape.z), kChild,
                     [shape](Workbench& workbench) { return runShape(shape, workbench); },
                     [shape](Workbench& workbench) { return compileShape(shape, workbench); }});
  }
  for (const std::uint32_t size : kSubgroupSizes) {
    cases.push_back({fmt::format("group.subgroup.{}", size), kChild,
                     [size](Workbench& workbench) { return runSubgroup(size, workbench); },
                     [size](Workbench& workbench) { return compileSubgroup(size, workbench); }});
  }
  return cases;
}

}  // namespace candela::conformance
