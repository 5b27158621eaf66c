// What tells one kernel from another: the code, what it keeps of each pixel between dispatches, and what it costs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "host/render/flat_scene.h"
#include "host/render/renderer.h"

namespace candela {

struct Kernel {
  const char* name;  ///< as in RenderStatistics::kernel
  std::span<const std::uint32_t> spirv;
  std::uint32_t stateBytes;      ///< of a pixel
  /// Adds the counts in one pixel's state, which is `stateBytes` long.
  void (*addCounts)(std::span<const std::byte> state, RenderStatistics& statistics);
};

/// Of the code of all kernels, as 64 hexadecimal digits.
std::string_view kernelsHash();

/// The most rays that one segment traces.
std::uint32_t mostRaysPerSegment(const Scene& scene, const RenderSettings& settings);

/// The kernel of the integrator that `settings` ask for.
Kernel kernelFor(const FlatScene& flat, const RenderSettings& settings);

}  // namespace candela
