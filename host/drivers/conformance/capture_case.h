// Turns a case into a program that repeats it without Candela.
#pragma once
#include "host/drivers/capture/capture.h"
#include "host/drivers/conformance/case.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::conformance {

/// Runs a case on the device and returns its last dispatch, whose results the case states. Capture::found
/// describes the difference. `prepareShader` is DeviceOptions::prepareShader; cases with their own Case::capture ignore
/// it. Throws UsageError if the case states no result of a single dispatch, or if the device lacks what it needs.
capture::Capture captureCase(const Case& question, const vulkan::DeviceInfo& device,
                             const vulkan::PrepareShader& prepareShader = {});

/// Throws UsageError: the device lacks a feature, as the text of a skipped case names it.
[[noreturn]] void refuseMissing(const vulkan::DeviceInfo& device, const std::string& feature);

}  // namespace candela::conformance
