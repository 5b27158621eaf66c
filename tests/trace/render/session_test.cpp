// Sessions of both tracers: films in any number of steps, other seeds, films made earlier.
#include <atomic>
#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/trace/render/session_support.h"

using namespace candela;
using namespace candela::device;

TEST_CASE("a film and its counts do not depend on how the samples are split into ranges", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    const render::RenderResult whole = renderer.render(scene, sessionSettings(), {});
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, sessionSettings());
    for (const render::SampleRange range : {render::SampleRange{0, 3}, {3, 4}, {0, 4}, {2, kSamples}}) {
      CHECK(session->advance(range, {}));
    }
    CHECK(session->film().hash() == whole.film.hash());
    requireEqualCounts(session->statistics(), whole.statistics);
  });
}

TEST_CASE("a film is read from the device once after each change", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  for (const std::uint64_t bandBytes : {64 << 20, 64 << 10}) {
    const auto renderer = makeGpuRenderer(testDevice(),
                                          {.loopLimit = std::nullopt, .form = std::nullopt, .maxBandBytes = bandBytes});
    const std::unique_ptr<render::Session> session = renderer->prepare(scene, sessionSettings());
    double readBefore = 0;
    for (const std::uint32_t end : {3u, kSamples}) {
      CHECK(session->advance({0, end}, {}));
      const std::uint64_t hash = session->film().hash();
      const render::RenderStatistics first = session->statistics();
      CHECK(first.seconds.at("readBack") > readBefore);
      CHECK(session->film().hash() == hash);
      const render::RenderStatistics second = session->statistics();
      CHECK(second.seconds.at("readBack") == first.seconds.at("readBack"));
      requireEqualCounts(second, first);
      readBefore = first.seconds.at("readBack");
    }
  }
}

TEST_CASE("films of two ranges add up to the film of both", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    const std::unique_ptr<render::Session> first = renderer.prepare(scene, sessionSettings());
    const std::unique_ptr<render::Session> second = renderer.prepare(scene, sessionSettings());
    CHECK(first->advance({0, 5}, {}));
    CHECK(second->advance({5, kSamples}, {}));
    image::Film film = first->film();
    film.merge(second->film());
    CHECK(film.hash() == renderer.render(scene, sessionSettings(), {}).film.hash());
    CHECK(second->statistics().samples == 3 * 40 * 40);
  });
}

TEST_CASE("a session that was stopped continues where it was", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = sessionSettings();
  settings.execution.tile = render::Extent{16, 16};
  settings.execution.segmentsPerDispatch = 5;
  settings.execution.threads = 1;
  onAllRenderers([&](render::Renderer& renderer) {
    const render::RenderResult whole = renderer.render(scene, settings, {});
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
    std::atomic<bool> stop = false;
    int calls = 0;
    render::RenderControl control{&stop, [&](double, std::uint64_t) { stop = ++calls % 4 == 0; }};
    int stops = 0;
    while (!session->advance({0, kSamples}, control)) {
      stop = false;
      ++stops;
    }
    CHECK(stops > 1);
    CHECK(session->film().hash() == whole.film.hash());
    requireEqualCounts(session->statistics(), whole.statistics);
  });
}

TEST_CASE("a session continues the film of another session that was stopped", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = sessionSettings();
  settings.execution.tile = render::Extent{16, 16};
  settings.execution.threads = 1;
  onAllRenderers([&](render::Renderer& renderer) {
    const std::uint64_t whole = renderer.render(scene, settings, {}).film.hash();
    std::atomic<bool> stop = false;
    const std::unique_ptr<render::Session> first = renderer.prepare(scene, settings);
    CHECK_FALSE(first->advance({0, kSamples}, {&stop, [&](double, std::uint64_t samples) { stop = samples > 0; }}));
    const image::Film partial = first->film();
    CHECK(partial.hash() != whole);
    const std::unique_ptr<render::Session> second = renderer.prepare(scene, settings);
    second->load(partial);
    CHECK(second->advance({0, kSamples}, {}));
    CHECK(second->film().hash() == whole);
    CHECK(second->statistics().samples + first->statistics().samples == kSamples * 40 * 40);
    CHECK(second->statistics().cameraRays == second->statistics().samples);
  });
}

TEST_CASE("a session that is reset renders with the random numbers of the new seed", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    render::RenderSettings other = sessionSettings();
    other.image.seed = 77;
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, sessionSettings());
    CHECK(session->advance({0, kSamples}, {}));
    const std::uint64_t first = session->film().hash();
    session->reset(77, kSamples);
    CHECK(session->statistics().samples == 0);
    CHECK(session->advance({0, kSamples}, {}));
    CHECK(session->film().hash() == renderer.render(scene, other, {}).film.hash());
    session->reset(0, kSamples);
    CHECK(session->advance({0, kSamples}, {}));
    CHECK(session->film().hash() == first);
  });
}

// Strata and the jitter of other integrators than `path` depend on the number of samples.
TEST_CASE("a session that is reset renders with the new number of samples", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    for (const render::Integrator integrator : {render::Integrator::path, render::Integrator::whitted}) {
      render::RenderSettings settings = sessionSettings();
      settings.image.integrator = integrator;
      settings.image.maxDepth = render::defaultMaxDepth(integrator);
      settings.image.sampler = render::SamplerKind::stratified;
      settings.image.sampleCount = 1;
      const std::unique_ptr<render::Session> session = renderer.prepare(scene, settings);
      for (const std::uint32_t samples : {9u, 1u, 4u}) {
        CAPTURE(static_cast<int>(integrator), samples);
        settings.image.sampleCount = samples;
        settings.image.seed = samples;
        session->reset(samples, samples);
        CHECK(session->advance({0, samples}, {}));
        CHECK(session->film().hash() == renderer.render(scene, settings, {}).film.hash());
      }
    }
  });
}

TEST_CASE("sessions of the wavefront continue, too", "[swiftshader-slow]") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  render::RenderSettings settings = sessionSettings();
  settings.execution.kernel = render::KernelKind::wavefront;
  const std::uint64_t whole = testRenderer().render(scene, settings, {}).film.hash();
  const std::unique_ptr<render::Session> session = testRenderer().prepare(scene, settings);
  CHECK(session->advance({0, 3}, {}));
  const image::Film film = session->film();
  CHECK(session->advance({3, kSamples}, {}));
  CHECK(session->film().hash() == whole);
  const std::unique_ptr<render::Session> other = testRenderer().prepare(scene, settings);
  other->load(film);
  CHECK(other->advance({3, kSamples}, {}));
  CHECK(other->film().hash() == whole);
}

TEST_CASE("ranges that do not continue the film are refused, and so are films of other images") {
  const scene::Scene scene = loadTestScene("cornell.p3f");
  onAllRenderers([&](render::Renderer& renderer) {
    const std::unique_ptr<render::Session> session = renderer.prepare(scene, sessionSettings());
    CHECK_THROWS_AS(session->advance({0, kSamples + 1}, {}), UsageError);
    CHECK_THROWS_AS(session->advance({3, 2}, {}), UsageError);
    CHECK(session->advance({2, 4}, {}));
    CHECK_THROWS_AS(session->advance({5, 6}, {}), UsageError);
    CHECK_THROWS_AS(session->advance({0, 6}, {}), UsageError);
    CHECK_THROWS_AS(session->load(image::Film(40, 41)), UsageError);
    CHECK_THROWS_AS(session->load(session->film(), kSamples - 1), UsageError);
  });
}

TEST_CASE("a scene that prefers no structure gets a BVH if the device needs one") {
  std::string
      text = "v\nfrom 0 -9 3\nat 0 0 1\nup 0 0 1\nangle 40\nhither 0\nresolution 4 4\nf 1 1 1 1 0 0 0 0 1 0 1 0 0 0\n";
  for (int i = 0; i < 600; ++i) text += "s " + std::to_string(i) + " 3 0 .4\n";
  const scene::Scene scene = sceneFromText(text);
  const auto renderer = makeGpuRenderer(testDevice(), {.loopLimit = 2000});
  render::RenderSettings settings = squareSettings(4, 1);
  settings.structure.accel = render::AccelKind::none;
  CHECK_THROWS_AS(renderer->prepare(scene, settings), FileError);
  settings.structure.accelIsPreference = true;
  const render::RenderStatistics statistics = renderer->prepare(scene, settings)->statistics();
  CHECK(statistics.structure == render::AccelKind::bvh);
  REQUIRE(statistics.warnings.size() == 1);
  CHECK(statistics.warnings.front().find("600 primitives") != std::string::npos);
}
