// The rule by which a device traces small scenes as a linear list.
#pragma once
#include "host/trace/flatten/small_scene.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

/// Returns the rule as measured on lavapipe; for other devices, the cost of sixteen triangles.
flatten::SmallSceneRule smallSceneRule(const vulkan::DeviceInfo& info);

}  // namespace candela::device
