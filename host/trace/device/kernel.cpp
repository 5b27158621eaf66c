// Selects the kernels of an integrator.
#include "host/trace/device/kernel.h"

#include <algorithm>
#include <cstring>

#include "host/base/errors.h"
#include "spirv/hash.h"
#include "spirv/path.h"
#include "spirv/views.h"
#include "spirv/wave_extend.h"
#include "spirv/wave_gather.h"
#include "spirv/wave_renew.h"
#include "spirv/wave_shade.h"
#include "spirv/wave_shadow.h"
#include "spirv/whitted.h"

namespace candela::device {
namespace {

template <class State>
State headOf(std::span<const std::byte> bytes) {
  State state;
  std::memcpy(&state, bytes.data(), sizeof state);
  return state;
}

void addPathCounts(std::span<const std::byte> bytes, render::RenderStatistics& statistics) {
  const auto state = headOf<gpu::PathState>(bytes);
  // The wavefront may have generated a camera ray that is not traced yet.
  const bool underWay = state.throughputDepth.w > 1;
  statistics.cameraRays += state.radianceSample.w + (underWay ? 1 : 0);
  statistics.bounceRays += state.counts.bounceRays;
  statistics.shadowRays += state.counts.shadowRays;
  statistics.vertices += state.counts.vertices;
  statistics.traversalSteps += state.counts.steps;
}

static_assert(sizeof(gpu::TreeState) == gpu::kTreeRows * sizeof(gpu::uvec4));

void addTreeCounts(std::span<const std::byte> bytes, render::RenderStatistics& statistics) {
  const auto state = headOf<gpu::TreeState>(bytes);
  const bool underWay = state.node > 0;
  if (!statistics.treeRays) statistics.treeRays.emplace();
  statistics.cameraRays += state.radianceSample.w + (underWay ? 1 : 0);
  statistics.treeRays->cameraHits += state.cameraHits;
  statistics.treeRays->reflected += state.reflectedRays;
  statistics.treeRays->refracted += state.refractedRays;
  statistics.bounceRays += std::uint64_t{state.reflectedRays} + state.refractedRays;
  statistics.shadowRays += state.shadowRays;
  statistics.vertices += state.vertices;
  statistics.traversalSteps += state.steps;
}

}  // namespace

std::string_view kernelsHash() { return spirv::hash; }

std::uint32_t maxRaysPerSegment(const scene::Scene& scene, const render::RenderSettings& settings) {
  if (settings.image.integrator != render::Integrator::whitted) return 2;
  return 1 + static_cast<std::uint32_t>(std::min<std::size_t>(scene.pointLights.size(), gpu::kLightsPerSegment));
}

void requireKernel(const render::RenderSettings& settings) {
  if (settings.execution.kernel != render::KernelKind::wavefront ||
      settings.image.integrator == render::Integrator::path)
    return;
  throw UsageError("the wavefront kernels trace paths alone; the other integrators have one kernel");
}

Kernel kernelFor(const flatten::FlatScene& flat, const render::RenderSettings& settings) {
  requireKernel(settings);
  if (settings.image.integrator == render::Integrator::whitted) {
    const std::uint32_t stateBytes = flat.constants.stateRows * static_cast<std::uint32_t>(sizeof(gpu::uvec4));
    return {render::KernelInUse::whitted, {spirv::whitted}, stateBytes, addTreeCounts};
  }
  if (isView(settings.image.integrator))
    return {render::KernelInUse::views, {spirv::views}, sizeof(gpu::PathState), addPathCounts};
  if (settings.execution.kernelInUse() == render::KernelKind::megakernel) {
    return {render::KernelInUse::megakernel, {spirv::path}, sizeof(gpu::PathState), addPathCounts};
  }
  return {render::KernelInUse::wavefront,
          {spirv::wave_gather, spirv::wave_extend, spirv::wave_shade, spirv::wave_shadow, spirv::wave_renew},
          sizeof(gpu::WaveState),
          addPathCounts};
}

}  // namespace candela::device
