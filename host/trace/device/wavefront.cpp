// Records the stages of the wavefront kernel.
#include "host/trace/device/wavefront.h"

#include <array>
#include <cstddef>
#include <span>

namespace candela::device {
namespace {

class Rounds {
 public:
  Rounds(vulkan::CommandRecorder& recorder, const std::vector<vulkan::ComputePipeline>& stages,
         const vulkan::BindingSet& bindings, const vulkan::Buffer& results, const gpu::DispatchConstants& constants)
      : recorder_(recorder), stages_(stages), bindings_(bindings), results_(results), constants_(constants) {}

  /// Fills the queues of the first round.
  void begin(vulkan::GroupCount regionGroups) {
    constants_.roundParity = 1;  // as if a round of odd index had just ended
    empty(0, gpu::kQueueCount);
    recorder_.dispatch(pipeline(WaveStage::gather), bindings_, push(), regionGroups);
    run(WaveStage::renew, gpu::kQueueRenew);
  }

  void round(std::uint32_t number) {
    constants_.roundParity = number % 2;
    const bool even = constants_.roundParity == 0;
    // Empties all queues except that of the paths that this round extends.
    empty(even ? gpu::kQueueShadow : gpu::kQueueExtendEven, gpu::kQueueCount - 1);
    const std::uint32_t extended = even ? gpu::kQueueExtendEven : gpu::kQueueExtendOdd;
    run(WaveStage::extend, extended);
    run(WaveStage::shade, extended);
    run(WaveStage::shadow, gpu::kQueueShadow);
    run(WaveStage::renew, gpu::kQueueRenew);
  }

 private:
  static std::uint64_t headerOffset(std::uint32_t queue) {
    return sizeof(gpu::Counters) + queue * sizeof(gpu::QueueHeader);
  }

  const vulkan::ComputePipeline& pipeline(WaveStage stage) const { return stages_[static_cast<std::size_t>(stage)]; }
  std::span<const std::byte> push() const { return std::as_bytes(std::span(&constants_, 1)); }

  void empty(std::uint32_t firstQueue, std::uint32_t count) {
    constexpr gpu::QueueHeader kEmpty{0, 0, 1, 0};
    constexpr std::array<gpu::QueueHeader, gpu::kQueueCount> kHeaders{kEmpty, kEmpty, kEmpty, kEmpty};
    recorder_.updateBuffer(results_, headerOffset(firstQueue), std::as_bytes(std::span(kHeaders).first(count)));
  }

  void run(WaveStage stage, std::uint32_t queue) {
    recorder_.dispatchIndirect(pipeline(stage), bindings_, push(), results_, headerOffset(queue));
  }

  vulkan::CommandRecorder& recorder_;
  const std::vector<vulkan::ComputePipeline>& stages_;
  const vulkan::BindingSet& bindings_;
  const vulkan::Buffer& results_;
  gpu::DispatchConstants constants_;
};

}  // namespace

void recordRounds(vulkan::CommandRecorder& recorder, const std::vector<vulkan::ComputePipeline>& stages,
                  const vulkan::BindingSet& bindings, const vulkan::Buffer& results, gpu::DispatchConstants constants,
                  vulkan::GroupCount regionGroups, std::uint32_t rounds) {
  Rounds recorded(recorder, stages, bindings, results, constants);
  recorded.begin(regionGroups);
  for (std::uint32_t number = 0; number < rounds; ++number) recorded.round(number);
}

}  // namespace candela::device
