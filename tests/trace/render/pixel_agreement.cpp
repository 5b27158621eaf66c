// Renders on both tracers, and compares the pixels.
#include "tests/trace/render/pixel_agreement.h"

#include <catch2/catch.hpp>

#include "host/judge/verify/agreement.h"

namespace candela::device {

void checkPixelsAgree(const scene::Scene& scene, render::RenderSettings settings, double lit) {
  settings.execution.recordPaths = true;
  const verify::PixelAgreement pixels = verify::comparePixels(renderOnDevice(scene, settings),
                                                              renderOnReference(scene, settings));
  CAPTURE(settings.image.seed, settings.image.nextEventEstimation, pixels.equalFraction(), pixels.litEqualFraction(),
          pixels.lit, pixels.causes, pixels.worst, pixels.worstX, pixels.worstY);
  CHECK(static_cast<double>(pixels.lit) > lit * static_cast<double>(pixels.pixels));
  CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
  CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
}

}  // namespace candela::device
