// Traces a sample exactly and again with rounding, and compares the two.
#pragma once
#include "host/trace/reference/pixel_tracer.h"
#include "host/trace/reference/rounding/rounded_arithmetic.h"
#include "host/trace/reference/rounding/rounded_tracing.h"
#include "host/trace/render/path_trace.h"
#include "host/trace/render/replicas.h"

namespace candela::reference {

/// Growth of errors above which rounding acts as a random shift of the path rather than at one decision.
inline constexpr double kAmplified = 4096;

/// Traces replicas of the samples of a tracer, whose settings request them. Threads share it.
class ReplicaTracer {
 public:
  /// `eye`: the camera's position. The tracer must outlive the object, and its camera must not move.
  ReplicaTracer(const PixelTracer& tracer, const dvec3& eye)
      : tracer_(tracer), tracing_(tracer.scene(), tracer.tracing(), eye) {}

  /// Traces a sample exactly, which is returned, and `count` replicas of it. Adds the first replica's deviation to
  /// `deviation`. `replicas`, unless null, takes all of them.
  dvec3 trace(const render::PixelSample& sample, std::uint32_t count, Counters& counters, SampleOutputs outputs,
              render::Deviation& deviation, render::Replica* replicas) const;
  /// Traces replica `index`, from 0, of a sample.
  render::Replica trace(const render::PixelSample& sample, std::uint32_t index) const;
  /// Returns the arithmetic of replica `index`, from 0, of a sample. The object must outlive it.
  RoundedArithmetic arithmeticOf(const render::PixelSample& sample, std::uint32_t index) const;

 private:
  const PixelTracer& tracer_;
  RoundedTracing tracing_;
};

}  // namespace candela::reference
