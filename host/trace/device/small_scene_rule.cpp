// Tells the drivers apart on which a linear list was measured.
#include "host/trace/device/small_scene_rule.h"

namespace candela::device {

flatten::SmallSceneRule smallSceneRule(const vulkan::DeviceInfo& info) {
  // SwiftShader compiles every copy of an unrolled test, which took it minutes for eight spheres.
  if (info.driver.starts_with("SwiftShader")) return {.maxCost = 0};
  if (info.driver.starts_with("llvmpipe")) return {.maxCost = 128, .rowsAhead = true};
  return {};
}

}  // namespace candela::device
