// The properties in which kernels differ: the code, the state of a pixel between dispatches, and the costs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "host/trace/flatten/flat_scene.h"
#include "host/trace/render/statistics.h"

namespace candela::device {

struct Kernel {
  render::KernelInUse kind = render::KernelInUse::megakernel;
  std::vector<std::span<const std::uint32_t>> spirv;  ///< one module, or those of the wavefront, indexed by WaveStage
  std::uint32_t stateBytes = 0;                       ///< of a pixel
  /// Adds the counts in one pixel's state, which is `stateBytes` long.
  void (*addCounts)(std::span<const std::byte> state, render::RenderStatistics& statistics) = nullptr;

  bool isWavefront() const { return kind == render::KernelInUse::wavefront; }
};

/// SHA-256 over the code of all kernels, 64 hexadecimal digits.
std::string_view kernelsHash();

/// Maximum number of rays that one segment traces.
std::uint32_t maxRaysPerSegment(const scene::Scene& scene, const render::RenderSettings& settings);

/// Throws UsageError if the settings request the wavefront of an integrator that has none.
void requireKernel(const render::RenderSettings& settings);

/// Returns the kernel of the integrator that `settings` request. Throws as requireKernel().
Kernel kernelFor(const flatten::FlatScene& flat, const render::RenderSettings& settings);

}  // namespace candela::device
