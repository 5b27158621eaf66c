// The rounds of the wavefront: the order of its stages, and their queues. shaders/wavefront.glsl describes the
// stages.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/command_recorder.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "shaders/shared/render_data.h"

namespace candela::device {

/// The stages, in the order of Kernel::spirv.
enum class WaveStage { gather, extend, shade, shadow, renew };

inline constexpr std::array kWaveStageNames{"gather", "extend", "shade", "shadow", "renew"};

/// Maximum number of rounds recorded into one submission. Each round is five commands.
inline constexpr std::uint32_t kMaxRounds = 1024;

/// Bytes of the queues of a band of `pixels`, which are stored between the counters and the path records.
constexpr std::uint64_t queueBytes(std::uint64_t pixels) {
  return gpu::kQueueCount * (sizeof(gpu::QueueHeader) + sizeof(gpu::uint) * pixels);
}

/// Records `rounds` rounds, each a segment of every unfinished path of the region in `constants`, whose `bandPixels` is
/// the number of pixels of the band. `results`, one of the `bindings`, must have been created for Usage::indirect;
/// `regionGroups` cover the region.
void recordRounds(vulkan::CommandRecorder& recorder, const std::vector<vulkan::ComputePipeline>& stages,
                  const vulkan::BindingSet& bindings, const vulkan::Buffer& results, gpu::DispatchConstants constants,
                  vulkan::GroupCount regionGroups, std::uint32_t rounds);

}  // namespace candela::device
