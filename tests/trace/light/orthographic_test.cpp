// Orthographic cameras: the device's pixels are the reference's, whatever the kernel.
#include <catch2/catch.hpp>

#include "host/judge/verify/agreement.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

scene::Scene seenInParallel(const char* name, float height) {
  scene::Scene scene = loadTestScene(name);
  scene.camera->orthographicHeight = height;
  return scene;
}

void requireParallelPixels(const scene::Scene& scene, render::RenderSettings settings) {
  settings.execution.recordPaths = true;
  const verify::PixelAgreement pixels = verify::comparePixels(renderOnDevice(scene, settings),
                                                              renderOnReference(scene, settings));
  CAPTURE(scene.name, pixels.equalFraction(), pixels.litEqualFraction(), pixels.causes, pixels.worst, pixels.worstX,
          pixels.worstY);
  CHECK(pixels.lit > pixels.pixels / 4);
  CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
  CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
}

}  // namespace

TEST_CASE("orthographic views have the reference's pixels, with and without a lens, in wide and narrow images",
          "[swiftshader-slow]") {
  for (const float aperture : {0.0f, 12.0f}) {
    for (const char* const name : {"balls.p3f", "primitives.p3f", "cornell.p3f"}) {
      scene::Scene scene = seenInParallel(name, name[0] == 'c' ? 1.5f : 6.0f);
      scene.camera->aperture = aperture;
      scene.camera->focal = 0.75f;
      render::RenderSettings settings = squareSettings(64, 1);
      settings.image.size = {aperture > 0 ? 40u : 96u, 64u};
      requireParallelPixels(scene, settings);
    }
  }
}

TEST_CASE("orthographic views are the same by every kernel, and views and Whitted's tracer show them",
          "[swiftshader-slow]") {
  const scene::Scene scene = seenInParallel("balls.p3f", 5);
  render::RenderSettings settings = squareSettings(32, 4);
  const std::uint64_t hash = renderOnDevice(scene, settings).film.hash();
  settings.execution.kernel = render::KernelKind::wavefront;
  CHECK(renderOnDevice(scene, settings).film.hash() == hash);
  settings = squareSettings(64, 1);
  settings.image.integrator = render::Integrator::depth;
  requireParallelPixels(scene, settings);
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = render::defaultMaxDepth(render::Integrator::whitted);
  scene::Scene lit = primitivesUnderLights();
  lit.camera->orthographicHeight = 6.0f;
  requireParallelPixels(lit, settings);
}

TEST_CASE("depths of an orthographic view are distances from the plane through the eye", "[swiftshader-slow]") {
  scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 7\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 4 4\n"
      "f 1 1 1 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\n");
  scene.camera->orthographicHeight = 100.0f;
  render::RenderSettings settings = squareSettings(4, 1);
  settings.image.integrator = render::Integrator::depth;
  const image::Film film = renderOnDevice(scene, settings).film;
  for (std::uint32_t i = 0; i < 4; ++i) {
    CHECK(film.mean(i, 0).x == Approx(7).epsilon(1e-6));
    CHECK(film.mean(i, 3).x == Approx(7).epsilon(1e-6));
  }
}
