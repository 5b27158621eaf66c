// Reduces a dispatch to invocations that fail.
#pragma once
#include "host/drivers/capture/capture.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::capture {

/// Reduces a dispatch whose results differ on the device to the minimum number of neighbouring invocations, a power
/// of two, at which one still differs. The first push constant is the number of invocations, binding 0 has an equal
/// number of bytes for each, and so has binding 1, to which all expected values belong. Workgroups have `groupSize`
/// invocations. Work that is not of this form remains as it is. check() must have been called before, and is called at
/// the end.
void takeFewestInvocations(Capture& capture, const vulkan::DeviceInfo& device, std::uint32_t groupSize);

}  // namespace candela::capture
