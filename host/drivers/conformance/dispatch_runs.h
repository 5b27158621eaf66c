// Cases with several dispatches or commands in one submission, and with structures in buffers.
#pragma once
#include "host/drivers/conformance/case_pipeline.h"
#include "host/trace/vulkan/device.h"

namespace candela::conformance {

CasePipeline chainPipeline();
/// Dispatches, each of which reads the results of the previous one.
Finding runChain(vulkan::Device& device);
CasePipeline queuePipeline();
/// Rounds of a queue with indirect dispatches, as in the wavefront kernel.
Finding runQueue(vulkan::Device& device);
/// Fills, updates and copies of buffers.
Finding runCopies(vulkan::Device& device);
CasePipeline recordsPipeline();
/// Members of structures with the padding of std430.
Finding runRecords(vulkan::Device& device);

}  // namespace candela::conformance
