// Shrinks and captures the failures of `candela conformance`.
#pragma once
#include <filesystem>

#include "host/base/log.h"
#include "host/drivers/conformance/runner.h"

namespace candela::cli {

/// Searches for the smallest difference of the first variants that differ unexpectedly, and adds it to their texts.
/// Ends at an interruption.
void shrinkFailures(const conformance::ShrinkLimits& limits, conformance::RunResult& run,
                    const conformance::Cases& cases, const vulkan::DeviceInfo& device, const Log& log);

/// Captures the failures in a new folder; if it has no name, nowhere. Ends at an interruption; the captures before it
/// remain.
void captureFailures(const std::filesystem::path& folder, const conformance::RunResult& run,
                     const conformance::Cases& cases, const vulkan::DeviceInfo& device, const Log& log);

}  // namespace candela::cli
