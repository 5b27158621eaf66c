// The wavefront's rounds: which of its stages run when, and on what queues. shaders/wavefront.glsl says what they do.
#pragma once
#include <cstdint>
#include <vector>

#include "host/vulkan/binding_set.h"
#include "host/vulkan/buffer.h"
#include "host/vulkan/command_recorder.h"
#include "host/vulkan/compute_pipeline.h"
#include "shaders/shared/render_data.h"

namespace candela::device {

/// In the order of Kernel::spirv.
enum class WaveStage { gather, extend, shade, shadow, renew };

/// So many rounds may be recorded into one submission, each of five commands.
inline constexpr std::uint32_t kMaxRounds = 1024;

/// What the queues of a band of so many pixels take between the counters and the path records.
constexpr std::uint64_t queueBytes(std::uint64_t pixels) {
  return gpu::kQueueCount * (sizeof(gpu::QueueHead) + sizeof(gpu::uint) * pixels);
}

/// Records so many rounds, each a segment of every unfinished path of the region in `constants`, whose `work` has the
/// band's pixels in the place of loop turns. `results`, among `bindings`, is made for Usage::indirect; `regionGroups`
/// cover the region.
void recordRounds(vulkan::CommandRecorder& recorder, const std::vector<vulkan::ComputePipeline>& stages,
                  const vulkan::BindingSet& bindings, const vulkan::Buffer& results, gpu::DispatchConstants constants,
                  vulkan::GroupCount regionGroups, std::uint32_t rounds);

}  // namespace candela::device
