// Shrinks a difference between two variants of a kernel to the transformations that it needs.
#pragma once
#include "host/drivers/conformance/variant_question.h"

namespace candela::conformance {

/// Observes with fewer and fewer steps of the variant, in fewer and fewer modules, each time in a child process, as
/// long as the result differs from that of the plain form. Returns a text that names the steps and the modules that
/// remain. None of them can be removed, unless the time was over, which the text then states. Call it while this
/// process has one thread. Throws InternalError if no child can be started.
std::string smallestDifference(const VariantQuestion& question, const vulkan::DeviceInfo& device,
                               const ShrinkLimits& limits);

}  // namespace candela::conformance
