// The requirements of the commands that need a device, or compare two tracers.
#pragma once
#include "host/cli/render_job.h"
#include "host/render/path_trace.h"

namespace candela::cli {

/// Throws UsageError if the reference tracer is chosen. `reason` is a clause that says why a command cannot use it.
void requireVulkanDevice(const Arguments& arguments, const char* reason);

/// Each throws UsageError, with an alternative, if the arguments request something that makes no sense. None
/// needs the scene.
void requireVerifiable(const Arguments& arguments);
void requireComparable(const Arguments& arguments);
void requireExplainable(const Arguments& arguments);

/// Returns the sample of --pixel, which is given, and --sample. Throws UsageError if it is outside of the render.
render::PixelSample sampleAskedFor(const RenderJob& job);

}  // namespace candela::cli
