// A replay traces the very sample that a render traces.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "host/explain/explanation.h"
#include "tests/render/render_support.h"

using namespace candela;

namespace {

// Both tracers, as what can replay.
ReplayingRenderer& deviceTracer() {
  static const std::unique_ptr<ReplayingRenderer> tracer = makeGpuRenderer(testDevice());
  return *tracer;
}

ReplayingRenderer& referenceTracer() {
  static const std::unique_ptr<ReplayingRenderer> tracer = makeReferenceRenderer();
  return *tracer;
}

void forEachPixel(const Extent& size, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  for (std::uint32_t y = 0; y < size.height; ++y) {
    for (std::uint32_t x = 0; x < size.width; ++x) visit(x, y);
  }
}

// The film that all samples give when they are replayed one by one.
Film filmOfReplays(ReplayingRenderer& tracer, const Scene& scene, const RenderSettings& settings) {
  Film film(settings.size.width, settings.size.height);
  forEachPixel(settings.size, [&](std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t i = 0; i < settings.sampleCount; ++i) {
      film.addSample(x, y, tracer.replay(scene, settings, {x, y, i}).path.radiance, i);
    }
  });
  return film;
}

// The sums of radiance are integers: equal only if every sample is, bit for bit.
void requireFilmOfReplays(ReplayingRenderer& tracer, const Scene& scene, const RenderSettings& settings) {
  const Film rendered = tracer.render(scene, settings, {}).film;
  const Film replayed = filmOfReplays(tracer, scene, settings);
  std::uint32_t lit = 0;
  forEachPixel(settings.size, [&](std::uint32_t x, std::uint32_t y) {
    CAPTURE(scene.name, x, y);
    const FilmPixel& a = rendered.at(x, y);
    const FilmPixel& b = replayed.at(x, y);
    CHECK(a.red == b.red);
    CHECK(a.green == b.green);
    CHECK(a.blue == b.blue);
    CHECK(a.sampleCount == b.sampleCount);
    lit += a.red != FixedSum{} ? 1 : 0;
  });
  CHECK(lit > settings.size.width * settings.size.height / 2);
}

}  // namespace

TEST_CASE("the samples that are replayed add up to the rendered film, bit for bit", "[swiftshader-slow]") {
  const auto onBoth = [](const Scene& scene, const RenderSettings& settings) {
    SECTION("device") { requireFilmOfReplays(deviceTracer(), scene, settings); }
    SECTION("reference") { requireFilmOfReplays(referenceTracer(), scene, settings); }
  };
  SECTION("every kind of primitive and material") { onBoth(loadTestScene("primitives.p3f"), squareSettings(8, 3)); }
  SECTION("strata, whose numbers depend on how many samples there are; a lens and a tent") {
    RenderSettings settings = squareSettings(6, 4);
    settings.sampler = SamplerKind::stratified;
    settings.filter = FilterKind::tent;
    settings.rouletteStart = 1;
    onBoth(loadTestScene("depth_of_field.p3f"), settings);
  }
}

TEST_CASE("a path of thousands of vertices is replayed over many dispatches, of which the first 64 are kept") {
  const Scene scene = loadTestScene("mirrors.p3f");
  RenderSettings settings = squareSettings(4, 1);
  settings.maxDepth = 3000;
  const PixelSample place{0, 0, 0};  // between the mirrors
  for (ReplayingRenderer* tracer : {&deviceTracer(), &referenceTracer()}) {
    const Replay replay = tracer->replay(scene, settings, place);
    CHECK(replay.statistics.truncated == 0);
    CHECK(replay.path.vertexCount == 3000);
    REQUIRE(replay.path.vertices.size() == PathTrace::kMostVertices);
    CHECK(replay.path.vertices.back().hit);
    Film replayed(1, 1);
    replayed.addSample(0, 0, replay.path.radiance, 0);
    CHECK(replayed.at(0, 0).red == tracer->render(scene, settings, {}).film.at(place.x, place.y).red);
  }
}

TEST_CASE("roulette spares the first vertices, and a path survives it by the square root of its throughput") {
  const Scene scene = loadTestScene("cornell.p3f");
  RenderSettings settings = squareSettings(6, 1);
  settings.rouletteStart = 2;
  for (ReplayingRenderer* tracer : {&deviceTracer(), &referenceTracer()}) {
    std::uint32_t played = 0;
    forEachPixel(settings.size, [&](std::uint32_t x, std::uint32_t y) {
      const PathTrace path = tracer->replay(scene, settings, {x, y, 0}).path;
      for (std::size_t i = 0; i < path.vertices.size(); ++i) {
        const VertexTrace& vertex = path.vertices[i];
        if (!vertex.roulette) continue;
        CAPTURE(x, y, i);
        CHECK(i >= settings.rouletteStart);
        REQUIRE(vertex.scattering);
        const glm::dvec3 throughput = vertex.throughput * vertex.scattering->weight;
        const double largest = std::max({throughput.x, throughput.y, throughput.z});
        CHECK(vertex.roulette->probability == Approx(std::min(1.0, std::sqrt(largest))).epsilon(1e-5));
        ++played;
      }
    });
    CHECK(played > 10);
  }
}

TEST_CASE("the two tracers' replays agree where their pixels do, and part by the same decision where they do not") {
  const Scene scene = loadTestScene("primitives.p3f");
  RenderSettings settings = squareSettings(12, 1);
  settings.recordPaths = true;
  const RenderResult a = deviceTracer().render(scene, settings, {});
  const RenderResult b = referenceTracer().render(scene, settings, {});
  settings.recordPaths = false;
  std::uint32_t agreeing = 0;
  forEachPixel(settings.size, [&](std::uint32_t x, std::uint32_t y) {
    const std::size_t pixel = std::size_t{y} * settings.size.width + x;
    const explain::Explanation explanation = explain::explainSample(scene, settings, {x, y, 0}, deviceTracer(),
                                                                    referenceTracer());
    agreeing += explanation.firstDifference ? 0 : 1;
    CAPTURE(x, y, explanation.verdict());
    if (explain::colour("pixel", a.film.mean(x, y), b.film.mean(x, y)).differs) CHECK(explanation.firstDifference);
    const Cause cause = causeOf(a.paths[pixel], b.paths[pixel]);
    if (explanation.firstDecision && cause != Cause::rounding) {
      const std::string name = explanation.at(*explanation.firstDecision).name;
      CHECK(name.find(kCauseNames[static_cast<std::size_t>(cause)]) != std::string::npos);
    }
  });
  CAPTURE(agreeing);
  CHECK(agreeing > 0.9 * settings.size.width * settings.size.height);
}
