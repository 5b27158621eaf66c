// Checks that both tracers find the same light at equal random numbers.
#pragma once
#include "tests/render/render_support.h"

namespace candela::device {

/// Renders on both tracers with equal random numbers and checks that their pixels agree (verify::comparePixels), and
/// that at least the share `lit` of them is not black.
void checkPixelsAgree(const scene::Scene& scene, render::RenderSettings settings, double lit = 0.25);

}  // namespace candela::device
