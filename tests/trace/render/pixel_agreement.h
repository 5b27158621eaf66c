// Checks that both tracers find the same light at equal random numbers.
#pragma once
#include "tests/trace/render/render_support.h"

namespace candela::device {

/// Renders on both tracers with equal random numbers. Checks that at least the fraction `lit` of the pixels is not
/// black, that kRequiredEqualFraction of all pixels are equal, and kRequiredLitEqualFraction of those that are not
/// black.
void checkPixelsAgree(const scene::Scene& scene, render::RenderSettings settings, double lit = 0.25);

}  // namespace candela::device
