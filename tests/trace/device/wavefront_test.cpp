// The wavefront gives the megakernel's film, bit for bit, its records and its counts.
#include <catch2/catch.hpp>

#include "host/trace/vulkan/loop_limit.h"
#include "tests/scene/generate/generated_text.h"
#include "tests/trace/light_tree_scenes.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

render::RenderSettings wavefrontSettings() {
  render::RenderSettings settings = squareSettings(44, 3);
  settings.image.size.height = 29;  // not a multiple of any workgroup
  settings.image.maxDepth = 9;
  return settings;
}

render::RenderResult renderWith(render::KernelKind kernel, const scene::Scene& scene, render::RenderSettings settings) {
  settings.execution.kernel = kernel;
  return renderOnDevice(scene, settings);
}

void requireSameAs(const render::RenderResult& mega, const render::RenderResult& waves) {
  CHECK(mega.statistics.kernel == render::KernelInUse::megakernel);
  CHECK(waves.statistics.kernel == render::KernelInUse::wavefront);
  CHECK(waves.film.hash() == mega.film.hash());
  requireEqualCounts(waves.statistics, mega.statistics);
}

render::RenderResult requireSame(const scene::Scene& scene, const render::RenderSettings& settings) {
  render::RenderResult waves = renderWith(render::KernelKind::wavefront, scene, settings);
  requireSameAs(renderWith(render::KernelKind::megakernel, scene, settings), waves);
  return waves;
}

}  // namespace

TEST_CASE("the wavefront gives the megakernel's film and counts: every primitive, mirrors, glass and mixtures") {
  const render::RenderResult waves = requireSame(loadTestScene("primitives.p3f"), wavefrontSettings());
  CHECK(waves.statistics.shadowRays > 0);
  CHECK(waves.statistics.bounceRays > 0);
}

TEST_CASE("the wavefront gives the megakernel's film and counts: a sky, a point light, no light at all",
          "[swiftshader-slow]") {
  for (const char* name : {"sky.p3f", "point_light.p3f", "furnace.p3f"}) {
    CAPTURE(name);
    requireSame(loadTestScene(name), wavefrontSettings());
  }
}

TEST_CASE("the wavefront gives the megakernel's film and counts: every scene file, with and without light sampling",
          "[slow]") {
  for (const std::filesystem::path& file : sceneFiles()) {
    for (const bool samplesLights : {true, false}) {
      CAPTURE(file.filename(), samplesLights);
      render::RenderSettings settings = wavefrontSettings();
      settings.image.nextEventEstimation = samplesLights;
      requireSame(loadTestScene(file.filename()), settings);
    }
  }
}

TEST_CASE(
    "the wavefront gives the megakernel's film and counts: tent filter, other samplers, --one-sided, no light sampling",
    "[swiftshader-slow]") {
  render::RenderSettings settings = wavefrontSettings();
  settings.image.nextEventEstimation = false;
  settings.image.oneSided = true;
  settings.image.filter.kind = render::FilterKind::tent;
  settings.image.sampler = render::SamplerKind::stratified;
  settings.image.sampleCount = 4;
  settings.image.rouletteStart = 1;
  requireSame(primitivesUnderLights(), settings);
}

TEST_CASE("the wavefront gives the megakernel's film and counts: lights chosen by a tree", "[swiftshader-slow]") {
  const scene::Scene scene = test::litRoom(120, 5, 20);
  for (const render::SamplerKind sampler : {render::SamplerKind::sobol, render::SamplerKind::stratified}) {
    render::RenderSettings settings = wavefrontSettings();
    settings.image.lights = render::LightSelection::tree;
    settings.image.sampler = sampler;
    settings.image.sampleCount = 4;
    requireSame(scene, settings);
  }
}

TEST_CASE("the structure does not change the film of the wavefront kernel", "[swiftshader-slow]") {
  const scene::Scene scene = primitivesUnderLights();
  for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh}) {
    CAPTURE(static_cast<int>(accel));
    render::RenderSettings settings = wavefrontSettings();
    settings.structure.accel = accel;
    settings.execution.sceneLoads = render::SceneLoads::storage;
    requireSame(scene, settings);
  }
}

TEST_CASE("workgroup, segments and tile do not change the film of the wavefront kernel", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  const render::RenderResult mega = renderWith(render::KernelKind::megakernel, scene, wavefrontSettings());
  const auto requireSameWith = [&](auto&& change) {
    render::RenderSettings settings = wavefrontSettings();
    change(settings);
    requireSameAs(mega, renderWith(render::KernelKind::wavefront, scene, settings));
  };
  for (const render::Extent workgroup : {render::Extent{1, 1}, render::Extent{3, 1}, render::Extent{16, 16}}) {
    CAPTURE(workgroup.width, workgroup.height);
    requireSameWith([&](render::RenderSettings& settings) { settings.execution.workgroup = workgroup; });
  }
  for (const std::uint32_t segments : {1u, 2u, 3u, 1000u}) {
    CAPTURE(segments);
    requireSameWith([&](render::RenderSettings& settings) { settings.execution.segmentsPerDispatch = segments; });
  }
  for (const render::Extent tile :
       {render::Extent{8, 8}, render::Extent{17, 5}, render::Extent{44, 1}, render::Extent{500, 500}}) {
    CAPTURE(tile.width, tile.height);
    requireSameWith([&](render::RenderSettings& settings) {
      settings.execution.tile = tile;
      settings.execution.segmentsPerDispatch = 2;
    });
  }
}

TEST_CASE("the wavefront gives the megakernel's film and counts at every size and depth", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("primitives.p3f");
  for (const render::Extent size : {render::Extent{1, 1}, render::Extent{1, 31}, render::Extent{33, 1}}) {
    for (const std::uint32_t depth : {1u, 9u}) {
      CAPTURE(size.width, size.height, depth);
      render::RenderSettings settings = wavefrontSettings();
      settings.image.size = size;
      settings.image.maxDepth = depth;
      requireSame(scene, settings);
    }
  }
}

TEST_CASE("a queue with more workgroups than one dimension permits loses no pixel", "[swiftshader-slow]") {
  render::RenderSettings settings = squareSettings(1, 1);
  settings.image.size = {520, 130};
  REQUIRE(settings.image.size.width * settings.image.size.height > 65535);
  settings.execution.workgroup = {1, 1};
  settings.execution.tile = settings.image.size;
  settings.image.maxDepth = 2;
  requireSame(loadTestScene("lamp_over_plane.p3f"), settings);
}

TEST_CASE("the wavefront and the megakernel record the same paths", "[swiftshader-slow]") {
  render::RenderSettings settings = wavefrontSettings();
  settings.image.sampleCount = 1;
  settings.execution.recordPaths = true;
  settings.image.maxDepth = 40;  // longer than what is recorded
  settings.image.rouletteStart = 3;
  for (const char* name : {"primitives.p3f", "mirrors.p3f"}) {
    CAPTURE(name);
    const scene::Scene scene = loadTestScene(name);
    const render::RenderResult mega = renderWith(render::KernelKind::megakernel, scene, settings);
    const render::RenderResult waves = renderWith(render::KernelKind::wavefront, scene, settings);
    CHECK(waves.film.hash() == mega.film.hash());
    REQUIRE(waves.paths.size() == mega.paths.size());
    for (std::size_t pixel = 0; pixel < mega.paths.size(); ++pixel) {
      CAPTURE(pixel);
      REQUIRE(waves.paths[pixel].vertexCount == mega.paths[pixel].vertexCount);
      for (std::uint32_t i = 0; i < mega.paths[pixel].vertexCount; ++i) {
        REQUIRE(waves.paths[pixel].vertices[i] == mega.paths[pixel].vertices[i]);
      }
    }
  }
}

TEST_CASE("the wavefront and the megakernel count the same bad samples", "[swiftshader-slow]") {
  const scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 8\n"
      "f 0 0 0 1 0 0 0 0 1 0 1 1e7 1 1\ns 0 0 0 0.5\n");
  CHECK(requireSame(scene, wavefrontSettings()).statistics.badSamples > 0);
}

TEST_CASE("a wavefront render that is stopped returns the finished samples", "[swiftshader-slow]") {
  std::atomic<bool> stop = false;
  render::RenderControl control;
  control.stop = &stop;
  control.progress = [&](double, std::uint64_t done) { stop = done > 0; };
  render::RenderSettings settings = squareSettings(64, 4096);
  settings.execution.kernel = render::KernelKind::wavefront;
  const render::RenderResult result = testRenderer().render(loadTestScene("balls.p3f"), settings, control);
  CHECK(result.interrupted);
  CHECK(result.statistics.samples > 0);
  CHECK(result.statistics.samples < std::uint64_t{64} * 64 * 4096);
  CHECK(result.statistics.cameraRays >= result.statistics.samples);
  CHECK(result.statistics.cameraRays <= result.statistics.samples + std::uint64_t{64} * 64);
}

TEST_CASE("segments add up towards a device's loop limit in the megakernel, but not in the wavefront",
          "[swiftshader-slow]") {
  // The renderer is configured without a limit.
  const auto careless = makeGpuRenderer(testDevice(), {.loopLimit = vulkan::kUnlimitedIterations});
  vulkan::Device device = openTestDevice();
  const bool limited = vulkan::probeLoopLimit(device) != vulkan::kUnlimitedIterations;
  const scene::Scene scene = generatedScene("balls", 4).scene;
  render::RenderSettings settings = squareSettings(8, 8);
  settings.structure.accel = render::AccelKind::none;
  settings.image.maxDepth = 4;
  settings.execution.segmentsPerDispatch = 1000;
  settings.execution.kernel = render::KernelKind::megakernel;
  CHECK((careless->render(scene, settings, {}).statistics.truncated > 0) == limited);
  const std::uint64_t expected = renderOnDevice(scene, settings).film.hash();
  settings.execution.kernel = render::KernelKind::wavefront;
  const render::RenderResult waves = careless->render(scene, settings, {});
  CHECK(waves.statistics.truncated == 0);
  CHECK(waves.film.hash() == expected);
}

TEST_CASE("an integrator that traces no paths has no wavefront") {
  render::RenderSettings settings = wavefrontSettings();
  settings.execution.kernel = render::KernelKind::wavefront;
  for (const render::Integrator integrator : {render::Integrator::whitted, render::Integrator::normal}) {
    settings.image.integrator = integrator;
    settings.image.maxDepth = 4;
    CHECK_THROWS_WITH(testRenderer().render(loadTestScene("balls.p3f"), settings, {}),
                      Catch::Contains("the wavefront kernels trace paths alone"));
  }
}
