// Work that is too long for one dispatch, too much for one buffer, or too much for the device.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <random>

#include "host/base/errors.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/nff_loader.h"
#include "host/judge/verify/agreement.h"
#include "host/trace/vulkan/loop_limit.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

// A rough height field under a light: `cells` x `cells` x 2 triangles and a sphere.
scene::Scene heightField(std::uint32_t cells) {
  std::mt19937 random(7);
  scene::Scene scene = sceneFromText(
      "b 0.2 0.3 0.5\nv\nfrom 0.5 -1.2 1.2\nat 0.5 0.5 0\nup 0 0 1\nangle 40\nhither 0\nresolution 16 16\n"
      "f 1 1 1 1 0 0 0 0 1 0 1 9 9 9\ns 0.7 0.6 1 0.2\nf 0.8 0.7 0.6 1 0 0 0 0 1 0 1 0 0 0\ns 0.2 0.2 0.1 0.05\n");
  const float size = 1.0f / static_cast<float>(cells);
  std::vector<glm::vec3> points;
  for (std::uint32_t i = 0; i < (cells + 1) * (cells + 1); ++i) {
    const float height = static_cast<float>(random() >> 8) * 0x1p-24f * size;
    points.push_back({static_cast<float>(i % (cells + 1)) * size, static_cast<float>(i / (cells + 1)) * size, height});
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    addTriangle(scene, {{points[a], points[b], points[c]}}, 1);
  };
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t corner = y * (cells + 1) + x;
      add(corner, corner + 1, corner + cells + 2);
      add(corner, corner + cells + 2, corner + cells + 1);
    }
  }
  return scene;
}

std::uint64_t residentBytes() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

TEST_CASE("brute force over 8,000 primitives equals the reference, whatever the segments per dispatch",
          "[swiftshader-slow]") {
  const scene::Scene scene = heightField(64);
  REQUIRE(scene.primitives.size() > 8000);
  render::RenderSettings settings = squareSettings(32, 1);
  settings.structure.accel = render::AccelKind::none;
  settings.image.maxDepth = 8;
  settings.execution.recordPaths = true;
  const render::RenderResult free = renderOnDevice(scene, settings);
  CHECK(free.statistics.structure == render::AccelKind::none);
  const verify::PixelAgreement pixels = verify::comparePixels(free, renderOnReference(scene, settings));
  CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
  CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
  settings.execution.segmentsPerDispatch = 1;
  CHECK(renderOnDevice(scene, settings).film.hash() == free.film.hash());
  settings.structure.accel = render::AccelKind::bvh;
  const render::RenderResult hierarchy = renderOnDevice(scene, settings);
  CHECK(hierarchy.film.hash() == free.film.hash());
  CHECK(hierarchy.statistics.traversalSteps < free.statistics.traversalSteps / 10);
}

TEST_CASE("paths of thousands of segments equal the reference, whatever the segments per dispatch") {
  const scene::Scene scene = loadTestScene("mirrors.p3f");
  render::RenderSettings settings = squareSettings(16, 1);
  settings.image.maxDepth = 5000;
  settings.execution.recordPaths = true;
  const render::RenderResult reference = renderOnReference(scene, settings);
  CHECK(reference.statistics.vertices > 1000 * reference.statistics.samples);
  std::uint64_t hash = 0;
  for (const std::uint32_t segments : {1000u, 7u}) {
    settings.execution.segmentsPerDispatch = segments;
    const render::RenderResult device = renderOnDevice(scene, settings);
    const verify::PixelAgreement pixels = verify::comparePixels(device, reference);
    CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
    CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
    CHECK((hash == 0 || hash == device.film.hash()));
    hash = device.film.hash();
  }
}

TEST_CASE("a kernel that exceeds the device's loop limit is detected") {
  // The renderer is configured without a limit, so that its dispatches exceed the limit of a device that has one.
  const auto careless = makeGpuRenderer(testDevice(), {.loopLimit = vulkan::kUnlimitedIterations});
  vulkan::Device device = openTestDevice();
  const bool limited = vulkan::probeLoopLimit(device) != vulkan::kUnlimitedIterations;
  render::RenderSettings settings = squareSettings(8, 1);
  settings.image.maxDepth = limited ? 100000 : 100;
  settings.execution.segmentsPerDispatch = 100000;
  const scene::Scene scene = loadTestScene("mirrors.p3f");
  const render::RenderResult result = careless->render(scene, settings, {});
  if (limited) {
    CHECK(result.statistics.truncated > 0);
  } else {
    CHECK(result.statistics.truncated == 0);
  }
  CHECK(renderOnDevice(scene, settings).statistics.truncated == 0);
}

TEST_CASE("dispatches do not leak memory", "[swiftshader-slow]") {
  // lavapipe stores two megabytes of compiled code for each dispatch of a kernel that branches on uniform values, or
  // has a loop with uniform bounds, such as the second scene's loop over its infinite plane, which is not in the BVH.
  // The last two have surfaces that coincide, whose rules depend on records: a small scene, and one with a lamp in the
  // face of a box.
  const std::string view = "v from 0 0 1.2 at 0.3 0 3 up 1 0 0 angle 60 hither 0 resolution 16 16\n";
  const std::string glass = view + R"(f .9 .9 .9 0 0 0 0 0 1 1 1.5 0 0 0
box -1 -1 2 1 1 3
p 3
-1 -1 2
2 0 2
0 2 2
pl 0 0 3 1 0 3 0 1 3
f 0 0 0 1 0 0 0 0 1 0 1 5 5 5
s 2 -3 0 .4
)";
  const std::string lamp = view + R"(f .5 .5 .5 1 0 0 0 0 1 0 1 0 0 0
box -4 -4 3  4 4 4
f 0 0 0 1 0 0 0 0 1 0 1 5 5 5
p 4
-.7 -.5 3
.9 -.6 3
.8 .7 3
-.6 .5 3
)";
  const scene::Scene scene = GENERATE_COPY(loadTestScene("mirror.p3f"), loadTestScene("primitives.p3f"),
                                           scene::parseScene(glass, "glass", ".").scene,
                                           scene::parseScene(lamp, "lamp", ".").scene);
  render::RenderSettings settings = squareSettings(16, 1);
  settings.structure.bvhLayout = GENERATE(render::BvhLayout::automatic, render::BvhLayout::cwbvh);
  settings.image.oneSided = true;
  settings.execution.segmentsPerDispatch = 1;
  settings.execution.tile = settings.image.size;
  renderOnDevice(scene, settings);
  const std::uint64_t before = residentBytes();
  settings.image.sampleCount = 64;
  const render::RenderResult result = renderOnDevice(scene, settings);
  REQUIRE(result.statistics.dispatchSeconds.size() >= 100);
  CHECK(residentBytes() < before + (std::uint64_t{64} << 20));
}

TEST_CASE("brute force beyond the device's loop limit is refused with a message") {
  const auto renderer = makeGpuRenderer(testDevice(), {.loopLimit = 65535});
  render::RenderSettings settings = squareSettings(8, 1);
  settings.structure.accel = render::AccelKind::none;
  CHECK_THROWS_WITH(renderer->render(heightField(129), settings, {}), Catch::Contains("use accel = bvh"));
}

TEST_CASE("the limit of brute force falls with the number of lights") {
  const auto renderer = makeGpuRenderer(testDevice(), {.loopLimit = 65535});
  scene::Scene scene = heightField(64);
  for (int i = 0; i < 20; ++i) scene.pointLights.push_back({glm::vec3(0.5f, 0.5f, 3), glm::vec3(0.1f)});
  render::RenderSettings settings = squareSettings(8, 1);
  settings.structure.accel = render::AccelKind::none;
  settings.image.integrator = render::Integrator::whitted;
  settings.image.maxDepth = 4;
  CHECK_THROWS_WITH(renderer->render(scene, settings, {}), Catch::Contains("at most 3633 primitives"));
}

TEST_CASE("a workgroup that the device does not have is refused with a message") {
  render::RenderSettings settings = squareSettings(8, 1);
  settings.execution.workgroup = {1024, 1024};
  CHECK_THROWS_AS(testRenderer().render(loadTestScene("balls.p3f"), settings, {}), UsageError);
}

TEST_CASE("a stopped render returns the finished samples") {
  std::atomic<bool> stop = false;
  render::RenderControl control;
  control.stop = &stop;
  control.progress = [&](double, std::uint64_t done) { stop = done > 0; };
  render::RenderSettings settings = squareSettings(64, 4096);
  const render::RenderResult result = testRenderer().render(loadTestScene("balls.p3f"), settings, control);
  CHECK(result.interrupted);
  CHECK(result.statistics.samples > 0);
  CHECK(result.statistics.samples < std::uint64_t{64} * 64 * 4096);
}

TEST_CASE("an image of 4096 x 2160 is rendered in bands that are not visible", "[slow]") {
  const scene::Scene scene = loadTestScene("lamp_over_plane.p3f");
  render::RenderSettings settings = squareSettings(1, 1);
  settings.image.size = {4096, 2160};
  settings.image.maxDepth = 3;
  const render::RenderResult result = renderOnDevice(scene, settings);
  CHECK(result.statistics.samples == std::uint64_t{4096} * 2160);
  for (const image::FilmPixel& pixel : result.film.pixels()) REQUIRE(pixel.sampleCount == 1);
  CHECK(meanLuminance(result.film) == Approx(meanLuminance(renderOnReference(scene, settings).film)).epsilon(1e-4));
}
