// The requirements of the commands that need a device, or compare two tracers.
#pragma once
#include "host/app/cli/command_arguments.h"
#include "host/trace/render/path_trace.h"

namespace candela::cli {

/// Throws UsageError if the reference tracer is chosen. `reason` is a clause that says why a command cannot use it.
void requireVulkanDevice(const DeviceArguments& arguments, const char* reason);

/// Each throws UsageError, with an alternative, if the arguments request something that makes no sense. None
/// needs the scene.
void requireVerifiable(const VerifyArguments& arguments);
void requireComparable(const CompareArguments& arguments);
void requireExplainable(const ExplainArguments& arguments);

/// Returns the sample of --pixel, which is given, and --sample. Throws UsageError if it is outside of the render.
render::PixelSample sampleAskedFor(const SampleArguments& arguments, const render::ImageSettings& image);

}  // namespace candela::cli
