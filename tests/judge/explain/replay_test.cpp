// A replay traces exactly the sample that a render traces.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "host/judge/explain/explanation.h"
#include "tests/trace/render/render_support.h"

using namespace candela;

namespace {

render::Renderer& referenceTracer() {
  static const std::unique_ptr<render::Renderer> tracer = reference::makeReferenceRenderer();
  return *tracer;
}

void forEachPixel(const render::Extent& size, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  for (std::uint32_t y = 0; y < size.height; ++y) {
    for (std::uint32_t x = 0; x < size.width; ++x) visit(x, y);
  }
}

// Returns the film of all samples, replayed one by one.
image::Film filmOfReplays(render::Renderer& tracer, const scene::Scene& scene, const render::RenderSettings& settings) {
  image::Film film(settings.image.size.width, settings.image.size.height);
  forEachPixel(settings.image.size, [&](std::uint32_t x, std::uint32_t y) {
    for (std::uint32_t i = 0; i < settings.image.sampleCount; ++i) {
      film.addSample(x, y, tracer.replay(scene, settings, {x, y, i}).path.radiance, i);
    }
  });
  return film;
}

// The sums of radiance are integers: equal only if every sample is, bit for bit.
void requireFilmOfReplays(render::Renderer& tracer, const scene::Scene& scene, const render::RenderSettings& settings) {
  const image::Film rendered = tracer.render(scene, settings, {}).film;
  const image::Film replayed = filmOfReplays(tracer, scene, settings);
  std::uint32_t lit = 0;
  forEachPixel(settings.image.size, [&](std::uint32_t x, std::uint32_t y) {
    CAPTURE(scene.name, x, y);
    const image::FilmPixel& a = rendered.at(x, y);
    const image::FilmPixel& b = replayed.at(x, y);
    CHECK(a.red == b.red);
    CHECK(a.green == b.green);
    CHECK(a.blue == b.blue);
    CHECK(a.sampleCount == b.sampleCount);
    lit += a.red != image::FixedSum{} ? 1 : 0;
  });
  CHECK(lit > settings.image.size.width * settings.image.size.height / 2);
}

}  // namespace

TEST_CASE("the samples that are replayed add up to the rendered film, bit for bit", "[swiftshader-slow]") {
  const auto onBoth = [](const scene::Scene& scene, const render::RenderSettings& settings) {
    SECTION("device") { requireFilmOfReplays(device::testRenderer(), scene, settings); }
    SECTION("reference") { requireFilmOfReplays(referenceTracer(), scene, settings); }
  };
  SECTION("every kind of primitive and material") {
    onBoth(device::loadTestScene("primitives.p3f"), device::squareSettings(8, 3));
  }
  SECTION("strata, whose numbers depend on how many samples there are; a lens and a tent") {
    render::RenderSettings settings = device::squareSettings(6, 4);
    settings.image.sampler = render::SamplerKind::stratified;
    settings.image.filter.kind = render::FilterKind::tent;
    settings.image.rouletteStart = 1;
    onBoth(device::loadTestScene("depth_of_field.p3f"), settings);
  }
}

TEST_CASE("a path of thousands of vertices is replayed over many dispatches, and its first 64 vertices are recorded") {
  const scene::Scene scene = device::loadTestScene("mirrors.p3f");
  render::RenderSettings settings = device::squareSettings(4, 1);
  settings.image.maxDepth = 3000;
  const render::PixelSample place{0, 0, 0};  // between the mirrors
  for (render::Renderer* tracer : {&device::testRenderer(), &referenceTracer()}) {
    const render::Replay replay = tracer->replay(scene, settings, place);
    CHECK(replay.statistics.truncated == 0);
    CHECK(replay.path.vertexCount == 3000);
    REQUIRE(replay.path.vertices.size() == render::PathTrace::kMaxVertices);
    CHECK(replay.path.vertices.back().hit);
    image::Film replayed(1, 1);
    replayed.addSample(0, 0, replay.path.radiance, 0);
    CHECK(replayed.at(0, 0).red == tracer->render(scene, settings, {}).film.at(place.x, place.y).red);
  }
}

TEST_CASE(
    "roulette starts after the first vertices, and the survival probability is the square root of the throughput") {
  const scene::Scene scene = device::loadTestScene("cornell.p3f");
  render::RenderSettings settings = device::squareSettings(6, 1);
  settings.image.rouletteStart = 2;
  for (render::Renderer* tracer : {&device::testRenderer(), &referenceTracer()}) {
    std::uint32_t played = 0;
    forEachPixel(settings.image.size, [&](std::uint32_t x, std::uint32_t y) {
      const render::PathTrace path = tracer->replay(scene, settings, {x, y, 0}).path;
      for (std::size_t i = 0; i < path.vertices.size(); ++i) {
        const render::VertexTrace& vertex = path.vertices[i];
        if (!vertex.roulette) continue;
        CAPTURE(x, y, i);
        CHECK(i >= settings.image.rouletteStart);
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

TEST_CASE("the replays of the two tracers agree if their pixels do, and otherwise diverge at the same decision") {
  const scene::Scene scene = device::loadTestScene("primitives.p3f");
  render::RenderSettings settings = device::squareSettings(12, 1);
  settings.execution.recordPaths = true;
  const render::RenderResult a = device::testRenderer().render(scene, settings, {});
  const render::RenderResult b = referenceTracer().render(scene, settings, {});
  settings.execution.recordPaths = false;
  std::uint32_t agreeing = 0;
  forEachPixel(settings.image.size, [&](std::uint32_t x, std::uint32_t y) {
    const std::size_t pixel = std::size_t{y} * settings.image.size.width + x;
    const explain::Explanation explanation = explain::explainSample(scene, settings, {x, y, 0}, device::testRenderer(),
                                                                    referenceTracer());
    agreeing += explanation.firstDifference ? 0 : 1;
    CAPTURE(x, y, explanation.verdict());
    if (explain::colour("pixel", a.film.mean(x, y), b.film.mean(x, y)).differs) CHECK(explanation.firstDifference);
    const verify::Cause cause = verify::causeOf(a.paths[pixel], b.paths[pixel]);
    if (explanation.firstDecision && cause != verify::Cause::rounding) {
      const std::string name = explanation.at(*explanation.firstDecision).name;
      CHECK(name.find(verify::kCauseNames[static_cast<std::size_t>(cause)]) != std::string::npos);
    }
  });
  CAPTURE(agreeing);
  CHECK(agreeing > 0.9 * settings.image.size.width * settings.image.size.height);
}
