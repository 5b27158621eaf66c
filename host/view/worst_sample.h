// The sample of a pixel on which two tracers agree least.
#pragma once
#include "host/render/replay.h"

namespace candela::view {

/// Returns the index of that sample among the first `count` of a pixel, whose radiance is replayed on both sides. A
/// maximum of 64 samples is searched.
std::uint32_t worstSample(render::SampleReplayer& device, render::SampleReplayer& reference, render::PixelSample sample,
                          std::uint32_t count);

}  // namespace candela::view
