// Traces a sample exactly and again with rounding, and compares the two.
#pragma once
#include "host/reference/pixel_tracer.h"
#include "host/render/path_trace.h"
#include "host/render/replicas.h"

namespace candela::reference {

/// Growth of errors above which rounding acts as a random shift of the path rather than at one decision.
inline constexpr double kAmplified = 4096;

/// Traces a sample exactly, which is returned, and `count` replicas of it. Adds the first replica's
/// deviation to `deviation`. `replicas`, unless null, takes all of them.
dvec3 traceReplicas(const PixelTracer& tracer, const render::PixelSample& sample, std::uint32_t count,
                    Counters& counters, SampleOutputs outputs, render::Deviation& deviation, render::Replica* replicas);

/// Traces replica `index`, from 0, of a sample.
render::Replica traceReplica(const PixelTracer& tracer, const render::PixelSample& sample, std::uint32_t index);

}  // namespace candela::reference
